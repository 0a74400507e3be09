#pragma once

#include "core/texture/photo/photo_mask.h"

#include <cstddef>
#include <vector>

namespace esm {

/// A part of a photo, its ends included; empty where an end lies before its begin.
struct PixelRange {
    int left, top, right, bottom;

    bool isEmpty() const { return right < left || bottom < top; }
    int width() const { return right - left + 1; }
    int height() const { return bottom - top + 1; }
};

/// How much of a stroke lies on each pixel that it reaches, 0 to 1.
struct StrokeCover {
    PixelRange range;
    std::vector<float> values; ///< row by row

    float& at(int x, int y) { return values[index(x, y)]; }
    float at(int x, int y) const { return values[index(x, y)]; }

private:
    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y - range.top) * static_cast<std::size_t>(range.width()) +
               static_cast<std::size_t>(x - range.left);
    }
};

/// Of a stroke on a part of a photo, by the greatest cover of its segments: laid on the mask segment by
/// segment, a soft stroke would grow harder where segments overlap, which is everywhere along its path.
/// Precondition: the path has a place.
StrokeCover coverOf(const PhotoStroke& stroke, const PixelRange& part);

} // namespace esm
