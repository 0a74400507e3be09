#pragma once

#include "core/geometry/border_loops.h"

namespace esm {

/// An open border as people are told of it.
struct OpenBorder {
    BorderLoop loop;
    double length; ///< of all its edges, unit of the vertices
    /// How far the opposite side is: half of the corners have it nearer. A slit's width, a round hole's
    /// diameter or a little less; infinite where nothing lies opposite. Unit of the vertices.
    double gap;
};

/// The one with the most edges first. Edges of no loop are left out.
std::vector<OpenBorder> openBordersOf(const TriangleMesh& mesh);
/// How many they have together: of all border edges, those that go around a hole.
std::size_t edgesOf(const std::vector<OpenBorder>& borders);

} // namespace esm
