#include "core/samples/implicit_surface.h"

#include <algorithm>
#include <cmath>

namespace esm {

/// An ellipsoid has no distance in closed form. With q = point / radii, |q| − 1 is 0 on it and grows by |q /
/// radii| / |q| per metre; their quotient is the distance to first order, right near the surface, where it is
/// used. In the centre, where it has no slope, the nearest way out is the smallest radius.
double ellipsoidDistance(const Eigen::Vector3d& point, const Eigen::Vector3d& centre,
                         const Eigen::Vector3d& radii) {
    const Eigen::Vector3d local = (point - centre).cwiseQuotient(radii);
    const double level = local.norm(), slope = local.cwiseQuotient(radii).norm();
    return slope > 0 ? level * (level - 1) / slope : -radii.minCoeff();
}

/// As if across the axis: for radii that change slowly along it that is right to first order, as Shape asks.
double roundConeDistance(const Eigen::Vector3d& point, const RoundCone& cone) {
    const Eigen::Vector3d along = cone.to - cone.from;
    const double place = std::clamp((point - cone.from).dot(along) / along.squaredNorm(), 0.0, 1.0);
    const double radius = cone.fromRadius + place * (cone.toRadius - cone.fromRadius);
    return (point - cone.from - place * along).norm() - radius;
}

/// The smooth minimum by a parabola (Quilez): beyond `width` the plain minimum, within it a rounded crease
/// without a bend at its ends. Taking away is joining with inside and outside exchanged.
double joined(double first, double second, double width) {
    const double overlap = std::max(width - std::abs(first - second), 0.0) / width;
    return std::min(first, second) - overlap * overlap * width / 4;
}

double carved(double body, double hollow, double width) {
    return -joined(-body, hollow, width);
}

namespace {

/// The distance's steepest growth, to first order of a small step; of length 1 for an exact distance.
Eigen::Vector3d slopeAt(const Shape& shape, const Eigen::Vector3d& point) {
    constexpr double step = 1e-6; // m
    const double here = shape(point);
    Eigen::Vector3d slope;
    for (int axis = 0; axis < 3; ++axis)
        slope[axis] = (shape(point + step * Eigen::Vector3d::Unit(axis)) - here) / step;
    return slope;
}

} // namespace

/// Smoothing alone would shrink the body, so only the part of the pull along the surface is taken, and half
/// of it, since all vertices move at once and would else swing. A Newton step along the slope then puts the
/// vertex back onto the surface; the slope's square is bounded below, as in the middle of the body there is
/// none.
void drawOnto(const Shape& shape, int rounds, TriangleMesh& mesh) {
    const std::vector<Edge> edges = uniqueEdges(mesh.triangles);
    for (int round = 0; round < rounds; ++round) {
        std::vector<Eigen::Vector3d> pulls(mesh.vertices.size(), Eigen::Vector3d::Zero());
        std::vector<double> counts(mesh.vertices.size(), 0);
        for (const auto& [a, b] : edges) {
            pulls[a] += mesh.vertices[b] - mesh.vertices[a];
            pulls[b] += mesh.vertices[a] - mesh.vertices[b];
            ++counts[a];
            ++counts[b];
        }
        for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
            Eigen::Vector3d& vertex = mesh.vertices[i];
            const Eigen::Vector3d slope = slopeAt(shape, vertex);
            const double squared = std::max(slope.squaredNorm(), 1e-6);
            const Eigen::Vector3d pull = pulls[i] / counts[i];
            vertex += 0.5 * (pull - slope * (slope.dot(pull) / squared));
            vertex -= slope * (shape(vertex) / squared);
        }
    }
}

} // namespace esm
