#include "core/texture/layers/brush_stroke.h"

#include <algorithm>
#include <cmath>

namespace esm {

namespace {

/// A triangle without area looks every way.
bool looksAlong(const Eigen::Vector3d& normal, const BrushPoint& point) {
    return normal.dot(point.normal) > 0 || normal.isZero(0);
}

/// From 0 at a segment's start to 1 at its end.
double fractionNearest(const Eigen::Vector3d& fromStart, const Eigen::Vector3d& along, double squaredLength) {
    return squaredLength > 0 ? std::clamp(fromStart.dot(along) / squaredLength, 0.0, 1.0) : 0;
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
    return problems;
}

Eigen::AlignedBox3d reachOf(const BrushStroke& stroke) {
    Eigen::AlignedBox3d box;
    for (const BrushPoint& point : stroke.path)
        box.extend(point.place);
    const Eigen::Vector3d radius = Eigen::Vector3d::Constant(stroke.radius);
    return {box.min() - radius, box.max() + radius};
}

double strokeProfile(const BrushStroke& stroke, double distance) {
    const double left = stroke.radius - distance, soft = stroke.softness * stroke.radius;
    if (left < 0) return 0;
    if (left >= soft) return stroke.strength;
    const double t = left / soft;
    return stroke.strength * t * t * (3 - 2 * t);
}

/// A triangle lies within a ball around its middle. A segment that stays farther from the middle than that
/// ball and the brush together cannot reach it: one distance for each segment here spares one for each
/// segment at every texel.
std::optional<StrokeOnTriangle> StrokeOnTriangle::make(const BrushStroke& stroke,
                                                       const Eigen::Matrix3d& corners, double margin) {
    const Eigen::Vector3d normal = (corners.col(1) - corners.col(0)).cross(corners.col(2) - corners.col(0));
    const Eigen::Vector3d middle = corners.rowwise().mean();
    const double size = (corners.colwise() - middle).colwise().norm().maxCoeff();
    const double reach = stroke.radius + size + margin;
    StrokeOnTriangle on;
    on.m_stroke = &stroke;
    for (std::size_t i = 0; i < stroke.path.size(); ++i) {
        const BrushPoint& start = stroke.path[i];
        const BrushPoint& end = stroke.path[std::min(i + 1, stroke.path.size() - 1)];
        if (i > 0 && i + 1 == stroke.path.size()) break; // the last point ends the segment before
        const Segment segment{start.place, end.place - start.place, (end.place - start.place).squaredNorm(),
                              looksAlong(normal, start), looksAlong(normal, end)};
        if (!segment.startFaces && !segment.endFaces) continue;
        const Eigen::Vector3d fromStart = middle - start.place;
        const double t = fractionNearest(fromStart, segment.along, segment.squaredLength);
        if ((fromStart - t * segment.along).squaredNorm() <= reach * reach) on.m_segments.push_back(segment);
    }
    if (on.m_segments.empty()) return std::nullopt;
    return on;
}

/// The greatest weight of all segments and not their sum, so that nothing builds up where segments meet or
/// the path crosses itself. Which half of a segment a point is nearest to decides whose side of the surface
/// counts: along an edge of the organ the path may turn to the other side.
double StrokeOnTriangle::weightAt(const Eigen::Vector3d& point) const {
    double weight = 0;
    for (const Segment& segment : m_segments) {
        const Eigen::Vector3d fromStart = point - segment.start;
        const double t = fractionNearest(fromStart, segment.along, segment.squaredLength);
        if (!(t < 0.5 ? segment.startFaces : segment.endFaces)) continue;
        weight = std::max(weight, strokeProfile(*m_stroke, (fromStart - t * segment.along).norm()));
    }
    return weight;
}

} // namespace esm
