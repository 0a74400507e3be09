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
};

} // namespace esm
