#pragma once

#include "core/support/fields.h"
#include "core/support/words.h"
#include "core/texture/image.h"
#include "core/texture/photo/outline_cover.h"
#include "core/texture/texture_limits.h"

#include <Eigen/Core>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace esm {

enum class FieldShape { Ellipse, Polygon };
template<>
inline constexpr auto wordsOf<FieldShape> =
    std::array{Word{FieldShape::Ellipse, "ellipse"}, Word{FieldShape::Polygon, "polygon"}};

constexpr std::size_t mostFieldCorners = 1000;

/// The picture that an endoscope leaves in a dark photo, in photo pixels from the top left corner. It may go
/// beyond the photo. A circle is an ellipse of equal radii.
struct PhotoField {
    FieldShape shape = FieldShape::Ellipse;
    Eigen::Vector2d centre = Eigen::Vector2d::Zero(); ///< of an ellipse, as the next two
    Eigen::Vector2d radii = Eigen::Vector2d::Zero();
    double angle = 0;     ///< degrees from the photo's x axis to that of the first radius, towards y
    PhotoOutline corners; ///< of a polygon
    double trim = 2;      ///< percent of its size, about its middle, that is left away at the rim

    static PhotoField circle(const Eigen::Vector2d& centre, double radius, double trim = 2) {
        return {FieldShape::Ellipse, centre, {radius, radius}, 0, {}, trim};
    }
    bool isCircle() const { return shape == FieldShape::Ellipse && radii.x() == radii.y() && angle == 0; }

    bool operator==(const PhotoField&) const = default;
};
template<>
inline constexpr auto fieldsOf<PhotoField> = [] {
    constexpr double most = texture_limits::longestFocalLength;
    constexpr auto isEllipse = [](const PhotoField& field) { return field.shape == FieldShape::Ellipse; };
    constexpr auto isPolygon = [](const PhotoField& field) { return field.shape == FieldShape::Polygon; };
    return fieldTable(
        field("shape", &PhotoField::shape),
        field("centre", &PhotoField::centre, Limits<double>{"the centre", -most, most, "pixels"})
            .onlyWhere(isEllipse),
        field("radii", &PhotoField::radii, Limits<double>{"the radii", 1, most, "pixels"})
            .onlyWhere(isEllipse),
        field("angle", &PhotoField::angle, Limits<double>{"the angle", -360, 360, "degrees"})
            .onlyWhere(isEllipse),
        field("corners", &PhotoField::corners, Limits<double>{"the corners", -most, most, "pixels"})
            .onlyWhere(isPolygon),
        field("trim", &PhotoField::trim, Limits<double>{"the trim", 0, 90, "%"}));
}();

/// Every problem of a field.
std::vector<std::string> validate(const PhotoField& field);

/// How far inside the rim a place lies, pixels, negative outside; near the rim of an ellipse, and exactly
/// otherwise. Not trimmed.
double distanceInside(const PhotoField& field, const Eigen::Vector2d& place);

/// The field's rim as a closed line, trimmed or not; an ellipse by 256 corners.
PhotoOutline outlineOf(const PhotoField& field, bool trimmed = true);

/// The field of a photo: a circle, an ellipse or a polygon, also where the frame cuts it off and where what
/// is around it is not quite black. Nothing where the picture fills the frame.
std::optional<PhotoField> findField(const Image& photo);

/// Takes the alpha outside the field away, over one pixel at its rim.
void maskField(Image& photo, const PhotoField& field);

} // namespace esm
