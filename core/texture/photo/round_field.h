#pragma once

#include "core/support/fields.h"
#include "core/texture/image.h"
#include "core/texture/texture_limits.h"

#include <Eigen/Core>

#include <optional>

namespace esm {

/// The round picture that an endoscope leaves in a dark photo, in photo pixels from the top left corner.
struct RoundField {
    Eigen::Vector2d centre = Eigen::Vector2d::Zero();
    double radius = 0;
    double trim = 2; ///< percent of the radius that is left away at the rim

    bool operator==(const RoundField&) const = default;
};
template<>
inline constexpr auto fieldsOf<RoundField> = [] {
    constexpr double most = texture_limits::longestFocalLength;
    return fieldTable(
        field("centre", &RoundField::centre, Limits<double>{"the centre", -most, most, "pixels"}),
        field("radius", &RoundField::radius, Limits<double>{"the radius", 1, most, "pixels"}),
        field("trim", &RoundField::trim, Limits<double>{"the trim", 0, 90, "%"}));
}();

/// The circle at which the dark rim ends, fitted to the border's points so that instruments, dark organs and
/// straight edges of the photo do not draw it aside. Nothing where there is no such border.
std::optional<RoundField> findRoundField(const Image& photo);

/// Takes the alpha outside the field away, over one pixel at its rim.
void maskField(Image& photo, const RoundField& field);

} // namespace esm
