#pragma once

#include "core/texture/image.h"

#include <array>
#include <optional>

namespace esm {

/// What red, green and blue are multiplied with.
using ColourGains = std::array<double, 3>;
constexpr double smallestGain = 0.25, largestGain = 4;

/// Gains that make what is nearly grey in the photo grey on average, green kept, each from 0.5 to 2. Pixels
/// count the more the brighter and the nearer to grey they are; strongly coloured, very dark and burnt out
/// ones do not. Nothing where less than a hundredth counts. Search before highlights are filled: their rims
/// show the lamp's colour.
std::optional<ColourGains> findWhiteBalance(const Image& photo);

void multiplyColours(Image& photo, const ColourGains& gains);

} // namespace esm
