#pragma once

#include "core/texture/image.h"

#include <algorithm>

namespace esm {

/// The four pixels around a place and how far it lies from the left and top ones, 0 to 1.
struct BilinearPlace {
    int left, right, top, bottom;
    double u, v;
};

/// Clamped at the image's borders as a texture is. The place is in pixels from the top left corner, a pixel's
/// centre at 0.5. Precondition: it is finite.
inline BilinearPlace bilinearPlace(const Image& image, double x, double y) {
    x = std::clamp(x - 0.5, 0.0, image.width - 1.0);
    y = std::clamp(y - 0.5, 0.0, image.height - 1.0);
    const int left = static_cast<int>(x), top = static_cast<int>(y);
    return {left,   std::min(left + 1, image.width - 1), top, std::min(top + 1, image.height - 1), x - left,
            y - top};
}

} // namespace esm
