#pragma once

#include "core/geometry/triangle_mesh.h"
#include "core/texture/atlas/atlas.h"

#include <Eigen/Core>

#include <optional>

namespace esm {

/// How a triangle's patch lies on the triangle: the tangent space in which normal maps are read, as glTF 2.0
/// has it. The bitangent is normal × tangent × handedness, and points to where the page's top is.
struct PatchFrame {
    Eigen::Vector3d tangent;  ///< of length 1, the direction on the surface that is to the right in the page
    Eigen::Vector3d normal;   ///< of the triangle, of length 1
    double handedness = 1;    ///< −1 of a patch that is mirrored
    Eigen::Matrix2d slopesOf; ///< from heights gained per texel to the right and downwards, in metres, to the
                              ///< slopes along tangent and bitangent
};

/// @param triangle of the mesh @return nothing of one without area, on the surface or in the page
std::optional<PatchFrame> patchFrame(const TriangleMesh& mesh, const Atlas& atlas, std::uint32_t triangle);

} // namespace esm
