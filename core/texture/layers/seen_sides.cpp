#include "core/texture/layers/seen_sides.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace esm {

namespace {

/// As seen from the eye, above 0 where the triangle turns its inside to it (Van Oosterom and Strackee 1983,
/// The solid angle of a plane triangle).
double solidAngle(const TriangleMesh& mesh, const Triangle& triangle, const Eigen::Vector3d& eye) {
    std::array<Eigen::Vector3d, 3> way;
    std::array<double, 3> length{};
    for (std::size_t i = 0; i < 3; ++i) {
        way[i] = mesh.vertices[triangle[i]] - eye;
        length[i] = way[i].norm();
    }
    const double below = length[0] * length[1] * length[2] + way[0].dot(way[1]) * length[2] +
                         way[1].dot(way[2]) * length[0] + way[2].dot(way[0]) * length[1];
    return 2 * std::atan2(sixfoldVolume(mesh.vertices, triangle, eye), below);
}

/// By how often each part winds around the eye: 0 outside of a closed one, 1 within, and what lies between
/// for a part with holes (Jacobson et al. 2013, Robust inside-outside segmentation using generalized winding
/// numbers). Unlike a ray's crossings it is not mistaken at an edge.
std::vector<SeenSide> sidesOfParts(const TriangleMesh& mesh, const Parts& parts, const Eigen::Vector3d& eye) {
    constexpr double nearlyWhole = 1e-3;
    std::vector<double> turns(parts.count, 0);
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
        turns[parts.ofTriangle[i]] += solidAngle(mesh, mesh.triangles[i], eye) / (4 * M_PI);
    std::vector<SeenSide> sides;
    sides.reserve(parts.count);
    for (const double turn : turns)
        sides.push_back(std::abs(turn) < nearlyWhole       ? SeenSide::Outside
                        : std::abs(turn - 1) < nearlyWhole ? SeenSide::Inside
                                                           : SeenSide::Both);
    return sides;
}

} // namespace

std::vector<SeenSide> seenSides(const TriangleMesh& mesh, const Projector& projector) {
    const bool asksForParts = projector.occlusion && !projector.isParallel();
    return seenSides(mesh, asksForParts ? connectedParts(mesh.triangles, mesh.vertices.size()) : Parts(),
                     projector);
}

std::vector<SeenSide> seenSides(const TriangleMesh& mesh, const Parts& parts, const Projector& projector) {
    std::vector<SeenSide> sides(mesh.triangles.size(), SeenSide::Both);
    if (!projector.occlusion) return sides;
    if (projector.isParallel()) {
        std::fill(sides.begin(), sides.end(), SeenSide::Outside);
        return sides;
    }
    const std::vector<SeenSide> ofPart = sidesOfParts(mesh, parts, projector.pose.translation());
    for (std::size_t i = 0; i < sides.size(); ++i)
        sides[i] = ofPart[parts.ofTriangle[i]];
    return sides;
}

} // namespace esm
