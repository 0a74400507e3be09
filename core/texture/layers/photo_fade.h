#pragma once

#include "core/texture/intrinsics.h"

#include <Eigen/Geometry>

#include <vector>

namespace esm {

/// How much of a photo has faded, on a grid over it. Without nodes nothing has.
struct PhotoFade {
    double spacing = 1;        ///< photo pixels between two nodes, the first at the top left corner
    int columns = 0, rows = 0; ///< nodes
    std::vector<float> faded;  ///< 0 (all is left) to 1, row by row

    /// 0 to 1 at a place of the photo, pixels. Precondition: it lies within the photo.
    double weightAt(double x, double y) const;
    /// Whether the weight is 1 at each place of a box, pixels.
    bool isClear(const Eigen::AlignedBox2d& box) const;
};

/// Photo pixels between nodes: near enough for what is read between them to be at most a sixteenth off where
/// a photo fades over `blendPixels`.
double nodeSpacing(double blendPixels);

/// A grid with nothing faded. Precondition: `blendPixels` > 0.
PhotoFade unfaded(PhotoSize photo, double blendPixels);

/// What both leave. Precondition: both are grids of one photo and one `blendPixels`, or without nodes.
PhotoFade fadedByBoth(PhotoFade fade, const PhotoFade& other);

} // namespace esm
