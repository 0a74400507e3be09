#pragma once

#include "core/geometry/triangle_mesh.h"

namespace esm {

/// A piece of the surface as a mesh of its own. Where it only touches itself at a vertex it has one for each
/// side, so that its border never meets itself.
struct ChartMesh {
    std::vector<std::uint32_t> triangles;            ///< of the surface, rising
    std::vector<Triangle> corners;                   ///< of each, the piece's own vertices
    std::vector<Eigen::Vector3d> vertices;           ///< m
    std::vector<std::vector<std::uint32_t>> borders; ///< vertices in turn, the piece on their left
    bool isDisc = false;                             ///< what can be laid flat: one border and no handle
};

/// @param across of the piece's triangles, as `DualGraph` has them: numbers within the piece
ChartMesh chartMesh(const TriangleMesh& surface, const std::vector<Triangle>& across,
                    std::vector<std::uint32_t> triangles);

} // namespace esm
