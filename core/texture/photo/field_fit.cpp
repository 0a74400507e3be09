#include "core/texture/photo/field_fit.h"

#include <Eigen/Dense>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace esm {

namespace {

constexpr int trials = 700; ///< of a few points each

/// A·x² + B·x·y + C·y² + D·x + E·y = 1, about a middle and in units of the photo's size.
using Conic = Eigen::Matrix<double, 5, 1>;

/// How many terms a conic has: a circle has one square for both axes, and only a turned ellipse has x·y.
enum class ConicKind { Circle = 3, Upright = 4, Turned = 5 };

/// How the photo's places are scaled, so that squares of large ones do not cancel.
struct Unit {
    Eigen::Vector2d middle;
    double size;
    Eigen::Vector2d to(const Eigen::Vector2d& place) const { return (place - middle) / size; }
};

Eigen::VectorXd termsOf(const Eigen::Vector2d& p, ConicKind kind) {
    const double xx = p.x() * p.x(), yy = p.y() * p.y();
    if (kind == ConicKind::Circle) return Eigen::Vector3d(xx + yy, p.x(), p.y());
    if (kind == ConicKind::Upright) return Eigen::Vector4d(xx, yy, p.x(), p.y());
    return Conic(xx, p.x() * p.y(), yy, p.x(), p.y());
}

Conic conicFrom(const Eigen::VectorXd& found, ConicKind kind) {
    if (kind == ConicKind::Circle) return Conic(found[0], 0, found[0], found[1], found[2]);
    if (kind == ConicKind::Upright) return Conic(found[0], 0, found[1], found[2], found[3]);
    return found;
}

/// The ellipse of a conic's equation, in pixels. Nothing where it is a hyperbola or has no point.
std::optional<PhotoField> ellipseOfConic(const Conic& conic, const Unit& unit) {
    Eigen::Matrix2d square;
    square << conic[0], conic[1] / 2, conic[1] / 2, conic[2];
    const Eigen::Vector2d linear(conic[3], conic[4]);
    if (!(square.determinant() > 1e-9)) return std::nullopt;
    const Eigen::Vector2d centre = -0.5 * square.ldlt().solve(linear);
    const double level = 1 + centre.dot(square * centre);
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(square / level);
    if (!centre.allFinite() || !(axes.eigenvalues().minCoeff() > 0)) return std::nullopt;
    PhotoField field;
    field.centre = unit.middle + unit.size * centre;
    field.radii = unit.size * axes.eigenvalues().cwiseSqrt().cwiseInverse();
    const Eigen::Vector2d first = axes.eigenvectors().col(0);
    field.angle = std::atan2(first.y(), first.x()) * 180 / M_PI;
    return field;
}

/// An upright ellipse has its first radius along x, and a circle has no angle.
PhotoField tidied(PhotoField field, ConicKind kind) {
    if (kind == ConicKind::Turned) return field;
    if (std::abs(std::sin(field.angle * M_PI / 180)) > 0.5) std::swap(field.radii.x(), field.radii.y());
    field.angle = 0;
    if (kind == ConicKind::Circle) field.radii.setConstant(field.radii.mean());
    return field;
}

/// Least squares of the conic's equation, which is linear, unlike that of the distances (for circles Kåsa
/// 1976).
std::optional<PhotoField> fittedConic(const FieldPoints& points, ConicKind kind, const Unit& unit) {
    const auto unknowns = static_cast<Eigen::Index>(kind);
    if (static_cast<Eigen::Index>(points.size()) < unknowns) return std::nullopt;
    Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(unknowns, unknowns);
    Eigen::VectorXd right = Eigen::VectorXd::Zero(unknowns);
    for (const Eigen::Vector2d& point : points) {
        const Eigen::VectorXd terms = termsOf(unit.to(point), kind);
        normal += terms * terms.transpose();
        right += terms;
    }
    const Eigen::VectorXd found = normal.ldlt().solve(right);
    if (!found.allFinite()) return std::nullopt;
    const auto field = ellipseOfConic(conicFrom(found, kind), unit);
    return field ? std::optional(tidied(*field, kind)) : std::nullopt;
}

FieldPoints pointsNear(const FieldPoints& points, const PhotoField& field, double tolerance) {
    FieldPoints on;
    on.reserve(points.size());
    std::copy_if(points.begin(), points.end(), std::back_inserter(on), [&](const Eigen::Vector2d& point) {
        return std::abs(distanceInside(field, point)) <= tolerance;
    });
    return on;
}

/// An endoscope's field is no sliver, and neither lies beside the photo nor shows a tiny part of itself.
bool isPlausible(const PhotoField& field, cv::Size size) {
    const double longest = std::max(size.width, size.height);
    const Eigen::Array2d place = field.centre.array() / Eigen::Array2d(size.width, size.height);
    return field.radii.maxCoeff() < 1.2 * longest && field.radii.minCoeff() > longest / 10 &&
           field.radii.minCoeff() > 0.45 * field.radii.maxCoeff() && (place > -0.1).all() &&
           (place < 1.1).all();
}

/// The conic through a few of the points that meets most of them: RANSAC (Fischler and Bolles 1981). Dark
/// tissue, instruments and what is burnt in are border points too, and least squares of all would be drawn
/// aside by them. If half of the points lie on an ellipse, five random ones do with 1/32, and 700 trials miss
/// it with a probability below 10⁻⁹. The generator is written out (Knuth's constants for a linear
/// congruential one) and begins at the same state, so that a photo always has the same field.
FieldPoints largestConsensus(const FieldPoints& points, ConicKind kind, cv::Size size, const Unit& unit,
                             double tolerance) {
    std::uint64_t state = 1;
    const auto few = static_cast<std::size_t>(kind);
    FieldPoints best, sample(few);
    for (int trial = 0; trial < trials; ++trial) {
        for (Eigen::Vector2d& point : sample) {
            state = state * 6364136223846793005U + 1442695040888963407U;
            point = points[(state >> 33) % points.size()];
        }
        const auto field = fittedConic(sample, kind, unit);
        if (!field || !isPlausible(*field, size)) continue;
        FieldPoints on = pointsNear(points, *field, tolerance);
        if (on.size() > best.size()) best = std::move(on);
    }
    return best;
}

/// The best conic of a few points is only as good as these. It is fitted again to all near it, until it has
/// settled.
std::optional<PhotoField> bestConic(const FieldPoints& points, ConicKind kind, cv::Size size,
                                    double tolerance) {
    if (points.size() < 30) return std::nullopt;
    const Unit unit{{size.width / 2.0, size.height / 2.0}, std::max(size.width, size.height) / 2.0};
    FieldPoints on = largestConsensus(points, kind, size, unit, 1.5 * tolerance);
    std::optional<PhotoField> field = fittedConic(on, kind, unit);
    for (int i = 0; i < 5 && field; ++i) {
        on = pointsNear(points, *field, tolerance);
        field = fittedConic(on, kind, unit);
    }
    return field && isPlausible(*field, size) ? field : std::nullopt;
}

/// A side of a polygon: what lies to the right of it, seen along it in a picture whose y goes down, is
/// inside.
struct HullSide {
    Eigen::Vector2d from, along;
    double depth(const Eigen::Vector2d& p) const {
        return along.x() * (p.y() - from.y()) - along.y() * (p.x() - from.x());
    }
};

/// The part of a polygon that lies inside of one more side (Sutherland and Hodgman 1974).
PhotoOutline cutAlong(const PhotoOutline& polygon, const HullSide& side) {
    PhotoOutline kept;
    kept.reserve(polygon.size() + 1);
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Eigen::Vector2d &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
        const double da = side.depth(a), db = side.depth(b);
        if (da >= 0) kept.push_back(a);
        if ((da >= 0) != (db >= 0)) kept.push_back(a + da / (da - db) * (b - a));
    }
    return kept;
}

/// The side moved to the middle of the points that lie along it. @returns false where there are few
bool moveToPoints(HullSide& side, double length, const FieldPoints& points, double reach) {
    std::vector<double> depths;
    depths.reserve(points.size());
    for (const Eigen::Vector2d& point : points) {
        const double place = side.along.dot(point - side.from), depth = side.depth(point);
        if (place > 0 && place < length && std::abs(depth) < reach) depths.push_back(depth);
    }
    if (4 * static_cast<double>(depths.size()) < length || depths.empty()) return false;
    const auto middle = depths.begin() + static_cast<std::ptrdiff_t>(depths.size() / 2);
    std::nth_element(depths.begin(), middle, depths.end());
    side.from += *middle * Eigen::Vector2d(-side.along.y(), side.along.x());
    return true;
}

std::vector<cv::Point> hullOf(const cv::Mat& lit, double tolerance) {
    std::vector<std::vector<cv::Point>> outlines;
    cv::findContours(lit, outlines, cv::RETR_EXTERNAL, cv::CHAIN_APPROX_NONE);
    std::vector<cv::Point> hull, corners;
    if (outlines.empty()) return {};
    cv::convexHull(outlines.front(), hull, true);
    cv::approxPolyDP(hull, corners, tolerance, true);
    if (cv::contourArea(corners, true) < 0) std::reverse(corners.begin(), corners.end());
    return corners;
}

} // namespace

std::optional<PhotoField> circleThrough(const FieldPoints& points, cv::Size size, double tolerance) {
    return bestConic(points, ConicKind::Circle, size, tolerance);
}

/// Upright at first, as squeezed pictures are; turned where that meets a tenth more points.
std::optional<PhotoField> ellipseThrough(const FieldPoints& points, cv::Size size, double tolerance) {
    const auto upright = bestConic(points, ConicKind::Upright, size, tolerance);
    const auto turned = bestConic(points, ConicKind::Turned, size, tolerance);
    if (!upright || !turned) return upright ? upright : turned;
    const auto met = [&](const PhotoField& field) { return pointsNear(points, field, tolerance).size(); };
    return 10 * met(*turned) > 11 * met(*upright) ? turned : upright;
}

/// The hull of the lit part passes over bites that dark tissue takes out of it. Its sides lie on pixels'
/// middles, or where noise reaches out furthest; points along a side place it better. Sides that few points
/// support, as at the frame, cut nothing off.
std::optional<PhotoField> polygonAround(const cv::Mat& lit, const FieldPoints& points, double tolerance) {
    const double w = lit.cols, h = lit.rows;
    PhotoField field;
    field.shape = FieldShape::Polygon;
    field.corners = {{0, 0}, {w, 0}, {w, h}, {0, h}};
    const std::vector<cv::Point> hull = hullOf(lit, tolerance);
    bool isCut = false;
    for (std::size_t i = 0; i < hull.size(); ++i) {
        const cv::Point &a = hull[i], &b = hull[(i + 1) % hull.size()];
        const Eigen::Vector2d from(a.x + 0.5, a.y + 0.5), along(b.x - a.x, b.y - a.y);
        HullSide side{from, along.normalized()};
        if (!moveToPoints(side, along.norm(), points, 3 * tolerance)) continue;
        field.corners = cutAlong(field.corners, side);
        isCut = true;
    }
    return isCut && field.corners.size() >= 3 ? std::optional(field) : std::nullopt;
}

} // namespace esm
