#pragma once

#include "core/geometry/triangle_mesh.h"

#include <cstddef>

namespace esm {

/// Pairs of triangles that run through each other: an edge of one pierces the inside of the other. What only
/// touches does not count, nor do neighbours folded onto each other.
struct SelfIntersections {
    std::size_t pairs = 0;
    Eigen::Vector3d first = Eigen::Vector3d::Zero(); ///< where the first of them meet
};
SelfIntersections selfIntersectionsOf(const TriangleMesh& mesh);

} // namespace esm
