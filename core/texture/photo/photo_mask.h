#pragma once

#include "core/support/fields.h"
#include "core/texture/image.h"
#include "core/texture/texture_limits.h"

#include <Eigen/Core>

#include <vector>

namespace esm {

/// A stroke of a round brush over a photo, in photo pixels from the top left corner, or an outline with all
/// that lies inside. It leaves text, overlays and instruments out, or takes back what strokes before it left
/// out.
struct PhotoStroke {
    std::vector<Eigen::Vector2d> path; ///< one place is a dab
    double radius = 20;                ///< pixels; of an outline, how far it reaches beyond its path
    double softness = 0;               ///< share of the radius over which it fades, 0 (hard) to 1
    bool takesBack = false;
    bool isFilled = false; ///< the path is closed, and its inside belongs to it

    bool operator==(const PhotoStroke&) const = default;
};
template<>
inline constexpr auto fieldsOf<PhotoStroke> = fieldTable(
    field("path", &PhotoStroke::path,
          Limits<double>{"the places", -texture_limits::longestFocalLength,
                         texture_limits::longestFocalLength, "pixels"}),
    field("radius", &PhotoStroke::radius, Limits<double>{"the radius", 0.5, 5000, "pixels"}),
    field("softness", &PhotoStroke::softness, Limits<double>{"the softness", 0, 1}),
    field("takesBack", &PhotoStroke::takesBack), field("filled", &PhotoStroke::isFilled).whenSet());

/// Takes the alpha of what the strokes leave out away, one stroke after another; even a hard one has an edge
/// of a pixel.
void maskStrokes(Image& photo, const std::vector<PhotoStroke>& strokes);

} // namespace esm
