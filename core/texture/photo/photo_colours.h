#pragma once

#include "core/texture/image.h"

#include <array>

namespace esm {

/// What red, green and blue are multiplied with.
using ColourGains = std::array<double, 3>;
constexpr double smallestGain = 0.25, largestGain = 4;

void multiplyColours(Image& photo, const ColourGains& gains);

} // namespace esm
