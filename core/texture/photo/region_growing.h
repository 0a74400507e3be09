#pragma once

#include "core/texture/photo/photo_mask.h"

#include <vector>

namespace esm {

/// Outlines around what hangs together with a place of the photo and has its colour, as an instrument, blood
/// or a bubble; what is transparent stays out. Empty where the place lies outside or is transparent.
/// @param tolerance by how much colours may differ, in CIE L*a*b* (1976), where lightness counts half
std::vector<PhotoStroke> growRegion(const Image& photo, const Eigen::Vector2d& seed, double tolerance);

} // namespace esm
