#pragma once

#include "core/texture/photo/photo_mask.h"

#include <opencv2/core.hpp>

#include <vector>

namespace esm {

/// Outlines around all parts of a mask, with strokes that take their holes back where asked for, so that the
/// strokes leave out what the mask has.
/// @param mask 255 and 0, 8 bit @param detail pixels by which an outline may miss the mask's border
std::vector<PhotoStroke> strokesAround(const cv::Mat& mask, double detail, bool withHoles);

} // namespace esm
