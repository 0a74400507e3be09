#pragma once

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace esm {

/// A surface as a file gives it, before repair: polygons of any size over vertices in the file's order and
/// unit.
struct PolygonSoup {
    std::vector<Eigen::Vector3d> vertices;
    std::vector<std::vector<std::uint32_t>> polygons; ///< vertex indices, three or more each
    /// Per polygon and corner, where it lies in a picture, as `CornerCoordinates`; empty where the file has
    /// none, and an empty list for a polygon without.
    std::vector<std::vector<Eigen::Vector2d>> textureCoordinates = {};
};

} // namespace esm
