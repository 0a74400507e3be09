#include "core/solid/prism.h"

#include <utility>

namespace esm {

// All triangles part their prisms by one order of the vertices, so that no prism has diagonals that chase
// each other around it: of those no three tetrahedra would be left. With the corners a, b and c in their
// order: (a, b, c, c'), (a, b, b', c') and (a, a', b', c'), a' being beneath a. Each side of the prism is
// parted from the lower corner outside to the higher one inside, which the neighbour does as well. Every
// other layer is its mirror image, so that diagonals lean both ways.
std::array<Tetrahedron, 3> prismOf(const Triangle& triangle, const std::vector<std::uint32_t>& order,
                                   std::uint32_t layer, std::uint32_t count) {
    const bool isMirrored = layer % 2 == 1;
    std::array<std::uint32_t, 3> corners = triangle;
    bool isEven = true;
    for (const auto& [i, j] : {std::pair<std::size_t, std::size_t>{0, 1}, {1, 2}, {0, 1}})
        if ((order[corners[i]] < order[corners[j]]) == isMirrored) {
            std::swap(corners[i], corners[j]);
            isEven = !isEven;
        }
    const std::uint32_t above = layer * count, below = above + count;
    const auto [a, b, c] = corners;
    std::array<Tetrahedron, 3> prism{Tetrahedron{a + above, b + above, c + above, c + below},
                                     Tetrahedron{a + above, b + above, c + below, b + below},
                                     Tetrahedron{a + above, b + below, c + below, a + below}};
    if (isEven)
        for (Tetrahedron& tetrahedron : prism)
            std::swap(tetrahedron[1], tetrahedron[2]);
    return prism;
}

} // namespace esm
