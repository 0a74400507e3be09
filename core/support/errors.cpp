#include "core/support/errors.h"

#include "core/support/joined.h"

#include <algorithm>
#include <new>

namespace esm {

namespace {

std::string inOneLine(const std::vector<std::string>& problems) {
    constexpr std::ptrdiff_t mostNamed = 20;
    const auto count = static_cast<std::ptrdiff_t>(problems.size());
    const std::string named = joined({problems.begin(), problems.begin() + std::min(count, mostNamed)}, "; ");
    return count <= mostNamed ? named : named + "; and " + std::to_string(count - mostNamed) + " more";
}

} // namespace

InvalidModel::InvalidModel(std::vector<std::string> problems)
    : std::runtime_error(inOneLine(problems)), m_problems(std::move(problems)) {}

std::string reasonOf(const std::exception& error) {
    if (dynamic_cast<const std::bad_alloc*>(&error)) return "there is not enough memory for it";
    return error.what();
}

} // namespace esm
