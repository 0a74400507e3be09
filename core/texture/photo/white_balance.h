#pragma once

#include "core/texture/image.h"
#include "core/texture/photo/highlights.h"
#include "core/texture/photo/photo_colours.h"

#include <Eigen/Core>

#include <optional>

namespace esm {

/// Gains that make grey what is white in the photo: the lamp's mirror images, or where there are none a drape
/// or an instrument. Green is kept, and each is from 0.5 to 2. Nothing where neither tells the lamp's colour
/// for sure, as where flecks do not agree or no lamp has such a colour: mucosa is red, never taken for grey.
/// Only what has alpha is looked at, before highlights are filled.
std::optional<ColourGains> findWhiteBalance(const Image& photo);

/// Gains that make the spot of so many pixels around a place grey. Nothing where it lies outside of what has
/// alpha, is nearly black, or is burnt out.
std::optional<ColourGains> whiteBalanceOfSpot(const Image& photo, const Eigen::Vector2d& place,
                                              double radius = 3);

/// Gains that give the photo's tissue the mean colour, not the brightness, that tissue has in another photo,
/// which is balanced. Of both what has alpha and is neither dark nor shines counts. Nothing where that is
/// less than a hundredth of either.
std::optional<ColourGains> whiteBalanceLike(const Image& photo, const Image& balanced);

} // namespace esm
