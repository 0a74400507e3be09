#pragma once

#include "core/project/project.h"

namespace esm {

/// What is drawn of a page of the texture: its triangles' corners, three by three.
struct PageVertices {
    std::vector<Eigen::Vector3d> positions, normals;
    std::vector<float> places;                  ///< in the texture, 0 to 1 from its top left; two per vertex
    std::vector<std::uint32_t> nodes, vertices; ///< of the surface
};

/// Every corner has a vertex of its own, since every triangle has a texture patch of its own.
/// @param normals of the surface's vertices @param triangles of the page
PageVertices pageVertices(const Project& project, const std::vector<Eigen::Vector3d>& normals,
                          const std::vector<std::uint32_t>& triangles);

} // namespace esm
