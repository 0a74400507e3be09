#include "core/solid/tetrahedron_cut.h"

namespace esm {

namespace {

Edge pointCorner(std::uint32_t point) {
    return {point, point};
}

Edge cutCorner(std::uint32_t one, std::uint32_t other) {
    return std::minmax(one, other);
}

} // namespace

TetrahedronPiece wholeOf(const Tetrahedron& corners) {
    TetrahedronPiece whole{{}, true};
    std::transform(corners.begin(), corners.end(), whole.corners.begin(), pointCorner);
    return whole;
}

// Points inside are a, b, c in the order of their numbers, each cut towards those outside. A face with two
// points inside and one outside keeps a quadrangle, which two tetrahedra share; both split it from the point
// with the lower number, so that they fit. By this order no prism is split round in a ring, which no
// tetrahedra could fill.
std::vector<TetrahedronPiece> piecesWithin(const Tetrahedron& corners, const std::array<Side, 4>& sides) {
    std::vector<std::uint32_t> within, on, outside;
    for (std::size_t i = 0; i < 4; ++i)
        (sides[i] == Side::Inside ? within : sides[i] == Side::On ? on : outside).push_back(corners[i]);
    if (within.empty()) return {};
    if (outside.empty()) return {wholeOf(corners)};
    std::sort(within.begin(), within.end());
    const std::uint32_t a = within[0];
    if (within.size() == 1) {
        TetrahedronPiece tip{{pointCorner(a)}, false};
        std::size_t next = 1;
        for (const std::uint32_t point : on)
            tip.corners[next++] = pointCorner(point);
        for (const std::uint32_t point : outside)
            tip.corners[next++] = cutCorner(a, point);
        return {tip};
    }
    const std::uint32_t b = within[1], x = outside[0];
    if (within.size() == 3) {
        const std::uint32_t c = within[2];
        return {{{pointCorner(a), cutCorner(a, x), cutCorner(b, x), cutCorner(c, x)}, false},
                {{pointCorner(a), pointCorner(b), cutCorner(b, x), cutCorner(c, x)}, false},
                {{pointCorner(a), pointCorner(b), pointCorner(c), cutCorner(c, x)}, false}};
    }
    if (on.size() == 1)
        return {{{pointCorner(on[0]), pointCorner(a), pointCorner(b), cutCorner(b, x)}, false},
                {{pointCorner(on[0]), pointCorner(a), cutCorner(b, x), cutCorner(a, x)}, false}};
    const std::uint32_t y = outside[1];
    return {{{pointCorner(a), pointCorner(b), cutCorner(b, x), cutCorner(b, y)}, false},
            {{pointCorner(a), cutCorner(a, x), cutCorner(a, y), cutCorner(b, y)}, false},
            {{pointCorner(a), cutCorner(a, x), cutCorner(b, y), cutCorner(b, x)}, false}};
}

} // namespace esm
