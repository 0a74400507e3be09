#include "core/texture/photo/photo_field.h"

#include "core/geometry/segment_distance.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tbb/parallel_for.h>

namespace esm {

namespace {

constexpr int ellipseCorners = 256;

double insidePolygon(const PhotoOutline& corners, const Eigen::Vector2d& place) {
    double nearest = std::numeric_limits<double>::infinity();
    bool isInside = false;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Eigen::Vector2d &from = corners[i], &to = corners[(i + 1) % corners.size()];
        nearest = std::min(nearest, distanceToSegment(place, from, to));
        if ((from.y() <= place.y()) == (to.y() <= place.y())) continue;
        const double share = (place.y() - from.y()) / (to.y() - from.y());
        if (from.x() + share * (to.x() - from.x()) > place.x()) isInside = !isInside;
    }
    return isInside ? nearest : -nearest;
}

Eigen::Rotation2Dd turnOf(const PhotoField& field) {
    return Eigen::Rotation2Dd(field.angle * M_PI / 180);
}

/// The distance from an ellipse to first order, q·(1 − q) / |∇| with q = |(x / a, y / b)|: exact for a
/// circle, and near the rim of any ellipse.
double insideEllipse(const PhotoField& field, const Eigen::Vector2d& place) {
    const Eigen::Array2d along = (turnOf(field).inverse() * (place - field.centre)).array();
    const double reach = (along / field.radii.array()).matrix().norm();
    const double slope = (along / field.radii.array().square()).matrix().norm();
    return slope > 0 ? reach * (1 - reach) / slope : field.radii.minCoeff();
}

PhotoField trimmedField(PhotoField field) {
    const double kept = 1 - field.trim / 100;
    field.radii *= kept;
    Eigen::Vector2d middle = Eigen::Vector2d::Zero();
    for (const Eigen::Vector2d& corner : field.corners)
        middle += corner / static_cast<double>(field.corners.size());
    for (Eigen::Vector2d& corner : field.corners)
        corner = middle + kept * (corner - middle);
    field.trim = 0;
    return field;
}

void multiplyAlpha(std::uint8_t* pixel, double share) {
    pixel[3] = static_cast<std::uint8_t>(std::lround(pixel[3] * std::clamp(share, 0.0, 1.0)));
}

} // namespace

double distanceInside(const PhotoField& field, const Eigen::Vector2d& place) {
    return field.shape == FieldShape::Ellipse ? insideEllipse(field, place)
                                              : insidePolygon(field.corners, place);
}

std::vector<std::string> validate(const PhotoField& field) {
    std::vector<std::string> problems = fieldProblems(field);
    if (field.shape == FieldShape::Polygon &&
        (field.corners.size() < 3 || field.corners.size() > mostFieldCorners))
        problems.push_back("there must be 3 to " + std::to_string(mostFieldCorners) + " corners");
    return problems;
}

PhotoOutline outlineOf(const PhotoField& field, bool trimmed) {
    const PhotoField shown = trimmed ? trimmedField(field) : field;
    if (shown.shape == FieldShape::Polygon) return shown.corners;
    PhotoOutline outline;
    outline.reserve(ellipseCorners);
    for (int i = 0; i < ellipseCorners; ++i) {
        const double turn = 2 * M_PI * i / ellipseCorners;
        const Eigen::Vector2d place =
            shown.radii.cwiseProduct(Eigen::Vector2d(std::cos(turn), std::sin(turn)));
        outline.emplace_back(shown.centre + turnOf(shown) * place);
    }
    return outline;
}

void maskField(Image& photo, const PhotoField& field) {
    const PhotoField shown = trimmedField(field);
    const bool isPolygon = shown.shape == FieldShape::Polygon;
    tbb::parallel_for(0, photo.height, [&](int y) {
        const std::vector<float> cover =
            isPolygon ? rowCoverOf(shown.corners, photo.width, y) : std::vector<float>();
        for (int x = 0; x < photo.width; ++x)
            multiplyAlpha(photo.at(x, y), isPolygon ? cover[static_cast<std::size_t>(x)]
                                                    : insideEllipse(shown, {x + 0.5, y + 0.5}) + 0.5);
    });
}

} // namespace esm
