#pragma once

#include "core/geometry/adjacency.h"
#include "core/geometry/triangle_mesh.h"
#include "core/texture/projection/projector.h"

#include <cmath>
#include <cstdint>
#include <vector>

namespace esm {

/// From which sides a projector colours surface.
enum class SeenSide : std::uint8_t { Outside, Inside, Both };

/// For each triangle. Of closed parts a projector sees the outside, and an eye within one its inside; of open
/// parts a parallel one sees the outside, and an eye both. One that does not ask what is hidden colours all
/// from both.
std::vector<SeenSide> seenSides(const TriangleMesh& mesh, const Projector& projector);
/// The same. @param parts of the mesh
std::vector<SeenSide> seenSides(const TriangleMesh& mesh, const Parts& parts, const Projector& projector);

/// Between the way to the light and the normal on the side that is seen, 0 on the other side.
/// @param cosine of the outward normal
inline double cosineSeen(SeenSide side, double cosine) {
    if (side == SeenSide::Both) return std::abs(cosine);
    return std::max(0.0, side == SeenSide::Inside ? -cosine : cosine);
}

} // namespace esm
