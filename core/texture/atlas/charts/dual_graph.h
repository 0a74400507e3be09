#pragma once

#include "core/geometry/triangle_mesh.h"

namespace esm {

/// Triangles of a surface as points that are joined where they share an edge.
struct DualGraph {
    std::vector<Triangle> across;         ///< of each, those across its sides; `noIndex` where there is none
    std::vector<Eigen::Vector3d> centres; ///< m
    std::vector<Eigen::Vector3d> normals; ///< of length 1; 0 of a triangle without area
    std::vector<double> areas;            ///< m²

    std::size_t size() const { return areas.size(); }
};

/// Of the whole surface. A triangle without area is joined with none, nor are triangles whose edge branches
/// or turns the inside out.
/// @param hasArea of each triangle
DualGraph dualGraph(const TriangleMesh& mesh, const std::vector<bool>& hasArea);

/// Of some of the triangles alone, numbered as they are in the list, which rises.
DualGraph partOf(const DualGraph& whole, const std::vector<std::uint32_t>& triangles);

} // namespace esm
