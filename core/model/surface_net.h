#pragma once

#include "core/geometry/triangle_mesh.h"
#include "core/model/spring_network.h"

#include <array>
#include <complex>
#include <vector>

namespace esm {

/// An angle φ as e^{2iφ}: what stretches along a line is the same for both ways along it.
using LineDirection = std::complex<double>;

/// A spring as one of its nodes sees it, in the plane that touches the surface there.
struct NetEnd {
    std::uint32_t node;
    Eigen::Vector2d along; ///< from the first node to the second; of length 1, or 0 where it stands upright
    LineDirection direction;
};

/// A spring along an edge of the surface.
struct NetSpring {
    std::size_t number; ///< among all springs
    std::array<NetEnd, 2> ends;
    double length; ///< m
    double area;   ///< m², of the triangles at it
};

struct NetTriangle {
    Triangle corners;
    std::array<std::uint32_t, 3> springs; ///< from each corner to the next; `noIndex` where none runs there
    std::array<LineDirection, 3> directions; ///< of these edges in the triangle's plane, the first at 0
    double area;                             ///< m²
};

/// A surface as a net of springs, with a plane of its own at each node and triangle.
struct SurfaceNet {
    std::vector<NetSpring> springs;
    std::vector<NetTriangle> triangles;
    std::vector<bool> isInside; ///< per node: the surface goes on all around it and does not branch
};

SurfaceNet surfaceNet(const std::vector<Eigen::Vector3d>& nodes, const std::vector<Spring>& springs,
                      const std::vector<Triangle>& triangles);

} // namespace esm
