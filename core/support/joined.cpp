#include "core/support/joined.h"

namespace esm {

std::string joined(const std::vector<std::string>& words, const std::string& separator) {
    std::string text;
    for (const std::string& word : words)
        text += (&word == &words.front() ? "" : separator) + word;
    return text;
}

} // namespace esm
