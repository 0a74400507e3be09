#pragma once

#include "core/solid/background_lattice.h"

#include <algorithm>
#include <vector>

namespace esm {

enum class Side : char { Outside, On, Inside };

/// A tetrahedron whose corners are points (named twice) or cuts of an edge (its points, the smaller first).
struct TetrahedronPiece {
    std::array<Edge, 4> corners;
    bool isWhole;
};

TetrahedronPiece wholeOf(const Tetrahedron& corners);

/// What of a tetrahedron lies within, its corners being inside, outside or on the surface. Nothing
/// where none is inside.
std::vector<TetrahedronPiece> piecesWithin(const Tetrahedron& corners, const std::array<Side, 4>& sides);

/// @param sideOf of a point
template<typename SideOf>
std::vector<TetrahedronPiece> piecesWithin(const Tetrahedron& corners, const SideOf& sideOf) {
    std::array<Side, 4> sides;
    std::transform(corners.begin(), corners.end(), sides.begin(), sideOf);
    return piecesWithin(corners, sides);
}

} // namespace esm
