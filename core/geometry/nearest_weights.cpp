#include "core/geometry/nearest_weights.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>

namespace esm {

// The foot of the perpendicular onto the plane has the weights of three areas, each a triple product with the
// normal (Heidrich 2005). Where all are positive it lies within and is the nearest point. Else the nearest
// point lies on the border, and that of each edge is tried: which edge it is cannot be told by the signs
// alone, as at obtuse corners a point beyond one edge is nearest to another. A triangle without area has no
// plane, and is its edges.
Eigen::Vector3d nearestWeights(const Eigen::Vector3d& point, const Eigen::Vector3d& a,
                               const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
    const auto onEdge = [&point](const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
        const Eigen::Vector3d along = to - from;
        const double squared = along.squaredNorm();
        return squared > 0 ? std::clamp((point - from).dot(along) / squared, 0.0, 1.0) : 0.0;
    };
    const Eigen::Vector3d ab = b - a, ac = c - a, ap = point - a;
    const Eigen::Vector3d normal = ab.cross(ac);
    const double squared = normal.squaredNorm();
    if (squared > 0) {
        const double weightB = ap.cross(ac).dot(normal) / squared,
                     weightC = ab.cross(ap).dot(normal) / squared;
        if (weightB >= 0 && weightC >= 0 && weightB + weightC <= 1)
            return {1 - weightB - weightC, weightB, weightC};
    }
    const double s = onEdge(a, b), t = onEdge(b, c), u = onEdge(c, a);
    const std::array<Eigen::Vector3d, 3> candidates{
        Eigen::Vector3d(1 - s, s, 0), Eigen::Vector3d(0, 1 - t, t), Eigen::Vector3d(u, 0, 1 - u)};
    const auto distance = [&](const Eigen::Vector3d& w) {
        return (w[0] * a + w[1] * b + w[2] * c - point).squaredNorm();
    };
    return *std::min_element(candidates.begin(), candidates.end(),
                             [&](const Eigen::Vector3d& left, const Eigen::Vector3d& right) {
                                 return distance(left) < distance(right);
                             });
}

} // namespace esm
