#pragma once

#include "core/project/project.h"

#include <string>
#include <vector>

namespace esm {

/// Rest lengths beyond so many times the length that the spring has at rest, and that springs have on
/// average, are slips, most often of a unit: such a spring presses its nodes apart as nine springs do that
/// are stretched to twice their length.
inline constexpr double mostPressed = 10;

/// What is hardly meant in a project that can be worked with all the same: points beyond all bounds, springs
/// pressed as no tissue is, a texture without size. Empty when all is well. Precondition: validate() finds
/// no problem.
std::vector<std::string> projectWarnings(const Project& project);

} // namespace esm
