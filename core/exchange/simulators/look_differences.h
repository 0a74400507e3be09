#pragma once

#include "core/exchange/simulators/difference.h"
#include "core/project/project.h"

#include <string>

namespace esm {

/// How a surface shines, and what keeps light off it, where a format has colours alone.
/// @param format as the subject of a sentence: "an MTL"
std::vector<Difference> lookDifferences(const Project& project, const std::string& format);

} // namespace esm
