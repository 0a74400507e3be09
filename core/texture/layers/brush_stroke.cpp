#include "core/texture/layers/brush_stroke.h"

#include "core/support/smooth_step.h"

#include <algorithm>
#include <cmath>

namespace esm {

namespace {

/// Cosine between the surface and the brush from which on the brush paints in full, that of 60°.
constexpr double facingCosine = 0.5;

/// Whether the brush comes from the front of any corner.
bool faces(const Eigen::Matrix3d& normals, const BrushPoint& start, const BrushPoint& end) {
    return std::max((start.normal.transpose() * normals).maxCoeff(),
                    (end.normal.transpose() * normals).maxCoeff()) > 0;
}

/// From 0 at a segment's start to 1 at its end.
double fractionNearest(const Eigen::Vector3d& fromStart, const Eigen::Vector3d& along, double squaredLength) {
    return squaredLength > 0 ? std::clamp(fromStart.dot(along) / squaredLength, 0.0, 1.0) : 0;
}

BrushShares sharesAt(const BrushStroke& stroke, std::size_t point) {
    return stroke.shares.empty() ? BrushShares() : stroke.shares[point];
}

BrushShares between(const BrushShares& start, const BrushShares& end, double t) {
    return {start.radius + t * (end.radius - start.radius),
            start.strength + t * (end.strength - start.strength)};
}

bool isShare(double value) {
    return value >= 0 && value <= 1;
}

bool isSound(const BrushPoint& point) {
    return point.place.allFinite() && point.normal.allFinite() && !point.normal.isZero(0);
}

} // namespace

std::vector<std::string> validate(const BrushStroke& stroke) {
    std::vector<std::string> problems = fieldProblems(stroke);
    if (stroke.path.empty()) problems.emplace_back("the path has no point");
    if (!std::all_of(stroke.path.begin(), stroke.path.end(), isSound))
        problems.emplace_back("the path has a point without a finite place or a direction");
    if (!stroke.shares.empty() && stroke.shares.size() != stroke.path.size())
        problems.emplace_back("its shares must be as many as its points, or none");
    if (!std::all_of(stroke.shares.begin(), stroke.shares.end(), [](const BrushShares& shares) {
            return isShare(shares.radius) && isShare(shares.strength);
        }))
        problems.emplace_back("its shares of radius and strength must be from 0 to 1");
    return problems;
}

BrushShares sharesBetween(const BrushStroke& stroke, std::size_t point, double t) {
    if (stroke.shares.empty()) return {};
    return between(stroke.shares[point], stroke.shares[std::min(point + 1, stroke.shares.size() - 1)], t);
}

Eigen::AlignedBox3d reachOf(const BrushStroke& stroke) {
    Eigen::AlignedBox3d box;
    for (const BrushPoint& point : stroke.path)
        box.extend(point.place);
    const Eigen::Vector3d radius = Eigen::Vector3d::Constant(stroke.radius);
    return {box.min() - radius, box.max() + radius};
}

double strokeProfile(const BrushStroke& stroke, double distance, const BrushShares& shares) {
    const double radius = shares.radius * stroke.radius, strength = shares.strength * stroke.strength;
    if (distance > radius) return 0;
    const double soft = stroke.softness * radius;
    return soft > 0 ? strength * smoothStep(0, soft, radius - distance) : strength;
}

/// A triangle lies within a ball around its middle. A segment that stays farther from the middle than that
/// ball and the brush together cannot reach it: one distance for each segment here spares one for each
/// segment at every texel.
std::optional<StrokeOnTriangle> StrokeOnTriangle::make(const BrushStroke& stroke,
                                                       const TriangleCorners& corners, double margin) {
    const Eigen::Vector3d middle = corners.places.rowwise().mean();
    const double size = (corners.places.colwise() - middle).colwise().norm().maxCoeff();
    const double reach = stroke.radius + size + margin;
    StrokeOnTriangle on;
    on.m_stroke = &stroke;
    for (std::size_t i = 0; i < stroke.path.size(); ++i) {
        const std::size_t next = std::min(i + 1, stroke.path.size() - 1);
        const BrushPoint &start = stroke.path[i], &end = stroke.path[next];
        if (i > 0 && i + 1 == stroke.path.size()) break; // the last point ends the segment before
        if (!faces(corners.normals, start, end)) continue;
        const Segment segment{start.place,
                              end.place - start.place,
                              (end.place - start.place).squaredNorm(),
                              start.normal.normalized(),
                              end.normal.normalized(),
                              sharesAt(stroke, i),
                              sharesAt(stroke, next)};
        const Eigen::Vector3d fromStart = middle - start.place;
        const double t = fractionNearest(fromStart, segment.along, segment.squaredLength);
        if ((fromStart - t * segment.along).squaredNorm() <= reach * reach) on.m_segments.push_back(segment);
    }
    if (on.m_segments.empty()) return std::nullopt;
    return on;
}

/// The greatest weight of all segments and not their sum, so that nothing builds up where segments meet or
/// the path crosses itself. Both the surface's normal and the brush's pass smoothly along triangles and path,
/// so that the strength does: asked triangle by triangle whether the brush faces it, a stroke would end along
/// their edges.
double StrokeOnTriangle::weightAt(const SurfacePoint& point) const {
    double weight = 0;
    for (const Segment& segment : m_segments) {
        const Eigen::Vector3d fromStart = point.place - segment.start;
        const double t = fractionNearest(fromStart, segment.along, segment.squaredLength);
        const double profile = strokeProfile(*m_stroke, (fromStart - t * segment.along).norm(),
                                             between(segment.startShares, segment.endShares, t));
        if (!(profile > weight)) continue;
        const Eigen::Vector3d towardsBrush =
            ((1 - t) * segment.startNormal + t * segment.endNormal).normalized();
        weight = std::max(weight, profile * smoothStep(0, facingCosine, towardsBrush.dot(point.normal)));
    }
    return weight;
}

} // namespace esm
