#pragma once

#include "core/texture/image.h"

#include <opencv2/core.hpp>

namespace esm {

/// Adds to a mask of highlights the lilac rims that lenses leave around them, as they bend blue light
/// otherwise than red: a highlight that is filled from them becomes a stain. What is as blue as its
/// surroundings, as dyed mucosa is, is none.
/// @param mask 255 and 0, 8 bit, of the photo's size @param reach pixels around the mask
void addFringes(cv::Mat& mask, const Image& photo, int reach);

} // namespace esm
