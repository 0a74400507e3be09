#pragma once

#include "core/texture/image.h"

#include <Eigen/Core>

#include <vector>

namespace esm {

/// A stroke of a round brush over a photo, in photo pixels from the top left corner. It leaves text, overlays
/// and instruments out, or takes back what strokes before it left out.
struct PhotoStroke {
    std::vector<Eigen::Vector2d> path; ///< one place is a dab
    double radius = 20;                ///< pixels
    double softness = 0;               ///< share of the radius over which it fades, 0 (hard) to 1
    bool takesBack = false;

    bool operator==(const PhotoStroke&) const = default;
};

/// Takes the alpha of what the strokes leave out away, one stroke after another; even a hard one has an edge
/// of a pixel.
void maskStrokes(Image& photo, const std::vector<PhotoStroke>& strokes);

} // namespace esm
