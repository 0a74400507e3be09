#pragma once

#include "core/project/project.h"

namespace esm {

/// What is drawn of a page of the texture.
struct PageVertices {
    std::vector<Eigen::Vector3d> positions, normals;
    std::vector<float> places;                  ///< in the texture, 0 to 1 from its top left; two per vertex
    std::vector<std::uint32_t> nodes, vertices; ///< of the surface
    std::vector<std::uint32_t> corners;         ///< of the page's triangles, in their order: which of these
    std::vector<float> tangents;                ///< four per vertex, as glTF has them; empty unless asked for
};

enum class WithTangents { No, Yes };

/// In charts and in the mesh's own layout triangles that are neighbours in the texture share vertices there;
/// where a vertex of the surface lies at several places, it is drawn by as many, and with tangents by one
/// more where the texture lies mirrored on one side of it. In other layouts every corner has a vertex of its
/// own, as readers of versions before 7 were promised.
/// @param normals of the surface's vertices @param triangles of the page
PageVertices pageVertices(const Project& project, const std::vector<Eigen::Vector3d>& normals,
                          const std::vector<std::uint32_t>& triangles, WithTangents withTangents);

} // namespace esm
