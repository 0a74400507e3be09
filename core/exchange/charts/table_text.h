#pragma once

#include <string>

namespace esm {

/// As tables have names that may hold commas, quotes or line breaks.
std::string quoted(const std::string& name);

} // namespace esm
