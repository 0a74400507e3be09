#pragma once

#include "core/geometry/triangle_mesh.h"
#include "core/support/progress.h"

#include <cstddef>

namespace esm {

/// Two triangles that run through each other: an edge of one pierces the inside of the other. What only
/// touches does not count, nor do neighbours folded onto each other.
struct MeetingTriangles {
    std::uint32_t one, other;
    Eigen::Vector3d place; ///< m
};
/// @throws Cancelled
std::vector<MeetingTriangles> meetingTriangles(const TriangleMesh& mesh, const Progress& progress = {});

/// All places where an edge of one of two such triangles pierces the other: the ends of what both have in
/// common.
std::vector<Eigen::Vector3d> piercings(const TriangleMesh& mesh, std::uint32_t one, std::uint32_t other);

/// How many such pairs there are.
struct SelfIntersections {
    std::size_t pairs = 0;
    Eigen::Vector3d first = Eigen::Vector3d::Zero(); ///< where the first of them meet
};
/// @throws Cancelled
SelfIntersections selfIntersectionsOf(const TriangleMesh& mesh, const Progress& progress = {});

} // namespace esm
