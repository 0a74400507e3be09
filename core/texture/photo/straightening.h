#pragma once

#include "core/texture/intrinsics.h"
#include "core/texture/photo/lens.h"

#include <vector>

namespace esm {

/// Places along something straight, in photo pixels from the top left corner.
using DrawnLine = std::vector<Eigen::Vector2d>;

/// The lens that makes drawn lines straight: the first radial coefficient from two lines on, the second as
/// well from three, with the line of sight in the photo's middle and a focal length of half the photo's
/// diagonal. Least squares of the places' distances from their lines (Devernay & Faugeras 2001, Straight
/// lines have to be straight). Lines of fewer than three places do not count.
/// @throws InvalidModel for fewer than two lines, or lines that do not tell how the lens bends
Lens straighteningLens(LensKind kind, const PhotoSize& size, const std::vector<DrawnLine>& lines);

/// What a lens without distortion would show where the photo shows `place`: the inverse of distorted() for a
/// lens with radial coefficients alone. Not finite where the lens shows nothing there.
Eigen::Vector2d straightened(const Lens& lens, const Eigen::Vector2d& place);

/// Root of the mean square of the places' distances from straight lines, as the lens leaves them, in photo
/// pixels.
double bending(const Lens& lens, const std::vector<DrawnLine>& lines);

} // namespace esm
