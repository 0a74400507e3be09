#pragma once

#include "core/geometry/triangle_mesh.h"

#include <functional>

namespace esm {

/// A body by its signed distance, m: negative inside, zero on its surface, right to first order near it.
using Shape = std::function<double(const Eigen::Vector3d&)>;

double ellipsoidDistance(const Eigen::Vector3d& point, const Eigen::Vector3d& centre,
                         const Eigen::Vector3d& radii);

/// A ball that moves along a line and changes its radius.
struct RoundCone {
    Eigen::Vector3d from, to;    ///< m
    double fromRadius, toRadius; ///< m
};
double roundConeDistance(const Eigen::Vector3d& point, const RoundCone& cone);

/// Of two bodies joined, or of the second taken away from the first; the crease is rounded over `width`, m.
double joined(double first, double second, double width);
double carved(double body, double hollow, double width);

/// A line through a body from end to end, by a parameter from 0 to 1.
struct Axis {
    std::function<Eigen::Vector3d(double)> at;
    Eigen::Vector3d side; ///< nowhere along the line
};

/// A closed mesh around a body whose sections across the axis are seen whole from it: rings of as many
/// vertices as fit at `spacing`, m, and a vertex at either end, then evened by drawOnto().
TriangleMesh meshAround(const Shape& shape, const Axis& axis, double spacing);

/// Evens a closed mesh on a body's surface: each round moves the vertices along the surface towards their
/// neighbours' mean, then back onto it.
void drawOnto(const Shape& shape, int rounds, TriangleMesh& mesh);

} // namespace esm
