#include "core/dynamics/contact/triangle_points.h"

#include "core/geometry/nearest_weights.h"

#include <algorithm>

namespace esm {

namespace {

using Eigen::Vector3d;

/// From the axis' line to a point.
Vector3d fromLine(const ColliderAxis& axis, const Vector3d& point) {
    const Vector3d fromMiddle = point - axis.middle;
    return fromMiddle - fromMiddle.dot(axis.direction) * axis.direction;
}

bool isBetweenEnds(const ColliderAxis& axis, const Vector3d& point) {
    return std::abs(axis.foot(point)) < axis.half;
}

Vector3d pointAt(const Vector3d& weights, const TrianglePoints::Corners& corners) {
    return weights[0] * corners[0] + weights[1] * corners[1] + weights[2] * corners[2];
}

} // namespace

// The distance from an axis is convex over a triangle. Where a capsule lies across one, it is touched along a
// line, and to keep both ends of that line out keeps all of it out. Such ends lie where an end of the axis is
// next to the triangle's inside, or where the axis crosses an edge. A capsule thinner than the triangle may
// also stand right through it. Which of them is deepest need not be known: whatever lies inside becomes a
// contact. Looked at along the axis, the capsule's side is a circle and the axis a point, so that crossings
// are nearest points of lines to that point; nothing is divided by how parallel two lines are.
TrianglePoints::TrianglePoints(const ColliderAxis& axis, const Corners& corners) {
    if (axis.isPoint()) {
        add(nearestWeights(axis.middle, corners[0], corners[1], corners[2]), AxisPart::First);
        return;
    }
    addEnds(axis, corners);
    addEdges(axis, corners);
    addPierced(axis, corners);
}

void TrianglePoints::addEnds(const ColliderAxis& axis, const Corners& corners) {
    const auto [least, most] =
        std::minmax({axis.foot(corners[0]), axis.foot(corners[1]), axis.foot(corners[2])});
    const auto addEnd = [&](double along, AxisPart part) {
        add(nearestWeights(axis.at(along), corners[0], corners[1], corners[2]), part);
    };
    if (least < -axis.half) addEnd(-axis.half, AxisPart::First);
    if (most > axis.half) addEnd(axis.half, AxisPart::Second);
}

void TrianglePoints::addEdges(const ColliderAxis& axis, const Corners& corners) {
    for (Eigen::Index i = 0; i < 3; ++i) {
        const auto first = static_cast<std::size_t>(i), second = (first + 1) % 3;
        const Vector3d from = fromLine(axis, corners.at(first)),
                       along = fromLine(axis, corners.at(second)) - from;
        const double squared = along.squaredNorm();
        const double share = squared > 0 ? -from.dot(along) / squared : 0;
        if (!(share > 0 && share < 1)) continue;
        Vector3d weights = Vector3d::Zero();
        weights[i] = 1 - share;
        weights[(i + 1) % 3] = share;
        if (isBetweenEnds(axis, pointAt(weights, corners))) add(weights, AxisPart::Between);
    }
}

void TrianglePoints::addPierced(const ColliderAxis& axis, const Corners& corners) {
    const Vector3d weights = nearestToLine(axis, corners);
    if (weights.minCoeff() > 0 && isBetweenEnds(axis, pointAt(weights, corners)))
        add(weights, AxisPart::Between);
}

Vector3d nearestToLine(const ColliderAxis& axis, const TrianglePoints::Corners& corners) {
    return nearestWeights(Vector3d::Zero(), fromLine(axis, corners[0]), fromLine(axis, corners[1]),
                          fromLine(axis, corners[2]));
}

} // namespace esm
