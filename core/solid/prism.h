#pragma once

#include "core/model/lattice.h"

#include <array>
#include <vector>

namespace esm {

/// Under a triangle three tetrahedra a layer, face to face with those of its neighbours.
/// @param order of the vertices: diagonals lead inwards from lower to higher
/// @param layer from the surface inwards, from 0
/// @param count of vertices of the surface: the node of a vertex beneath so many layers is layer · count + it
std::array<Tetrahedron, 3> prismOf(const Triangle& triangle, const std::vector<std::uint32_t>& order,
                                   std::uint32_t layer, std::uint32_t count);

} // namespace esm
