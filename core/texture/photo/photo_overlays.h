#pragma once

#include "core/texture/photo/photo_mask.h"

#include <vector>

namespace esm {

/// Tissue is red under any lamp: a colour with hardly any red in it is a box or a letter.
bool isNoTissue(const std::uint8_t* pixel);

/// Outlines around text and boxes that a camera's software burnt into the photo, where it has alpha: offered
/// as a mask, so that rather too much is covered than too little. Of the field only, where that is masked.
std::vector<PhotoStroke> findOverlays(const Image& photo);

} // namespace esm
