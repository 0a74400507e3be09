#include "core/support/errors.h"

namespace esm {

namespace {

std::string joined(const std::vector<std::string>& problems) {
    std::string text;
    for (const std::string& problem : problems)
        text += (text.empty() ? "" : "; ") + problem;
    return text;
}

} // namespace

InvalidModel::InvalidModel(std::vector<std::string> problems)
    : std::runtime_error(joined(problems)), m_problems(std::move(problems)) {}

} // namespace esm
