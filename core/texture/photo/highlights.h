#pragma once

#include "core/support/progress.h"
#include "core/texture/image.h"

#include <cstddef>

namespace esm {

constexpr int usualHighlightThreshold = 235;

/// Pixels whose darkest channel lies above the threshold, and a rim around them of two pixels or, in a large
/// photo, a 480th of its longer side.
std::size_t countHighlights(const Image& photo, int threshold);

/// Fills them from the tissue around them (Telea 2004, An image inpainting technique based on the fast
/// marching method), which is what is neither transparent nor nearly black; from what is nearly black where
/// there is nothing else. All other pixels stay as they are, and a highlight that has nothing around it.
/// @returns pixels filled
/// @throws Cancelled
std::size_t fillHighlights(Image& photo, int threshold, const Progress& progress = {});

} // namespace esm
