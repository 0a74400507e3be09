#include "core/model/wall_hinges.h"

#include "core/geometry/adjacency.h"

#include <Eigen/Geometry>

#include <cmath>
#include <numeric>

namespace esm {

namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Corners = std::array<std::uint32_t, 4>;

/// A hinge laid flat: the edge along x from the origin, the other corners above and below it.
struct FlatHinge {
    double edge;
    Vector2d above, below;
};

FlatHinge laidFlat(const Corners& corners, const std::vector<Vector3d>& places) {
    const Vector3d& start = places[corners[0]];
    const Vector3d edge = places[corners[1]] - start;
    const double length = edge.norm();
    const auto flat = [&](const Vector3d& corner, double side) {
        return Vector2d(edge.dot(corner) / length, side * edge.cross(corner).norm() / length);
    };
    return {length, flat(places[corners[2]] - start, 1), flat(places[corners[3]] - start, -1)};
}

// What one hinge is to store decides how the wall bends. A surface of the curvatures K, a symmetric matrix,
// opens the hinge between its two bars by s = K:Q, with Q = ½·Σ w·x·xᵀ. Bent into cylinders of curvature 1
// about all axes in turn, it does so by (tr² Q + 2·Q:Q)/8 in the mean of s². The hinge's constant κ, N/m, is
// what makes ½·κ·s² in that mean the energy ½·D of a plate of the hinge's share of the area, a third of both
// triangles. The regular net then bends exactly as the plate whichever way, since it has the plate's
// Poisson's ratio of ⅓ of itself. A net that is not regular bends so in the mean of all ways, but not each
// way alike. The usual constant D·l²/(A₁ + A₂) is the same on the regular net, but on one of squares with
// diagonals it is half as much again in that mean, on triangles drawn out by 2 twice as much.
//
// A radian of a flat hinge moves the bars apart by a·b/(a + b), with a and b the triangles' heights.
double stiffnessOf(const FlatHinge& hinge, double plate) {
    const auto& [edge, above, below] = hinge;
    const double a = above.y(), b = -below.y();
    const double onAcross = a / (a + b), onEdge = (above + onAcross * (below - above)).x() / edge;
    Matrix2d form = (1 - onAcross) * above * above.transpose() + onAcross * below * below.transpose();
    form(0, 0) -= onEdge * edge * edge;
    form /= 2;
    const double share = edge * (a + b) / 6;
    const double meanSquare = (std::pow(form.trace(), 2) + 2 * form.squaredNorm()) / 8;
    return plate * share / meanSquare * std::pow(a * b / (a + b), 2);
}

double meanOf(const Corners& corners, const std::vector<double>& perNode) {
    return std::accumulate(corners.begin(), corners.end(), 0.0,
                           [&](double sum, std::uint32_t node) { return sum + perNode[node] / 4; });
}

std::uint32_t cornerAcross(const Triangle& triangle, const Edge& edge) {
    for (const std::uint32_t node : triangle)
        if (node != edge.first && node != edge.second) return node;
    return edge.first;
}

} // namespace

double plateStiffness(double springConstant, double thickness) {
    constexpr double poissonRatio = 1.0 / 3;
    const double stretching = 2 / std::sqrt(3.0) * springConstant; // N/m, E·t
    return stretching * thickness * thickness / (12 * (1 - poissonRatio * poissonRatio));
}

std::vector<Hinge> wallHinges(const TissueModel& model, const std::vector<Triangle>& triangles,
                              double thickness) {
    const std::vector<Vector3d>& places = model.network->restPositions;
    std::vector<Hinge> hinges;
    forEachEdge(sidesByEdge(triangles), [&](auto first, auto last) {
        if (last - first != 2) return;
        const Edge& edge = first->edge;
        const Corners corners{edge.first, edge.second, cornerAcross(triangles[first->triangle], edge),
                              cornerAcross(triangles[(first + 1)->triangle], edge)};
        const double springConstant = meanOf(corners, model.springConstant);
        Hinge hinge{corners, 0, 0};
        if (!(springConstant > 0) || corners[2] == corners[3] || !shapeOf(hinge, places)) return;
        hinge.stiffness = stiffnessOf(laidFlat(corners, places), plateStiffness(springConstant, thickness));
        hinge.viscosity = hinge.stiffness * meanOf(corners, model.viscosity) / springConstant;
        hinges.push_back(hinge);
    });
    return hinges;
}

} // namespace esm
