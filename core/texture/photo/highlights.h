#pragma once

#include "core/texture/image.h"

#include <cstddef>

namespace esm {

constexpr int usualHighlightThreshold = 235;

/// Fills pixels whose darkest channel lies above the threshold, and a rim of two pixels around them, from
/// their surroundings (Telea 2004, An image inpainting technique based on the fast marching method). All
/// others, and transparent ones, stay as they are. Nothing is filled where nothing else is left. @returns
/// pixels filled
std::size_t fillHighlights(Image& photo, int threshold);

} // namespace esm
