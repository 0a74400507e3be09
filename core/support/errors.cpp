#include "core/support/errors.h"

#include <algorithm>

namespace esm {

namespace {

std::string joined(const std::vector<std::string>& problems) {
    constexpr std::size_t mostNamed = 20;
    std::string text;
    for (std::size_t i = 0; i < std::min(problems.size(), mostNamed); ++i)
        text += (i == 0 ? "" : "; ") + problems[i];
    if (problems.size() <= mostNamed) return text;
    return text + "; and " + std::to_string(problems.size() - mostNamed) + " more";
}

} // namespace

InvalidModel::InvalidModel(std::vector<std::string> problems)
    : std::runtime_error(joined(problems)), m_problems(std::move(problems)) {}

} // namespace esm
