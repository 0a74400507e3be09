#pragma once

#include "core/support/progress.h"
#include "core/texture/image.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace esm {

constexpr double usualSensitivity = 0.5;

/// A share or a yes or no for every pixel of a photo, row by row.
using PixelMask = std::vector<std::uint8_t>; ///< 255 where it is so, else 0

/// Where the lamp's mirror images are: brighter and less saturated than what surrounds them, with the soft
/// rims around them. What is pale and wider than flecks are, as polyps and organs, is spared unless it is
/// white. Only what has alpha is looked at. Takes a fifth of a second at most for 1920 × 1080
/// pixels.
/// @param sensitivity from 0, only what is white, to 1, also faint shine
PixelMask highlightMask(const Image& photo, double sensitivity);

/// The same as projects before version 10 say it: where the darkest channel is above a threshold, with a rim
/// of two pixels or, in a large photo, a 480th of its longer side.
PixelMask highlightsAbove(const Image& photo, int threshold);

/// Fills what the mask has from the tissue around it, which is what is neither transparent nor nearly black;
/// from what is nearly black where there is nothing else. All other pixels stay as they are, and a highlight
/// that has nothing around it. @returns pixels filled
/// @throws Cancelled
std::size_t fillHighlights(Image& photo, const PixelMask& mask, const Progress& progress = {});

} // namespace esm
