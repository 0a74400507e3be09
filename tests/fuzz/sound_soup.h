#pragma once

#include "core/geometry/polygon_soup.h"
#include "tests/fuzz/fuzz_target.h"

namespace esm::fuzz {

/// What those who take a surface rely on.
inline void expectSound(const PolygonSoup& soup) {
    for (const auto& polygon : soup.polygons) {
        expect(polygon.size() >= 3, "a polygon of fewer than three corners");
        for (const std::uint32_t corner : polygon)
            expect(corner < soup.vertices.size(), "a corner that names no vertex");
    }
    const auto& places = soup.textureCoordinates;
    expect(places.empty() || places.size() == soup.polygons.size(), "places of other polygons");
    for (std::size_t i = 0; i < places.size(); ++i)
        expect(places[i].empty() || places[i].size() == soup.polygons[i].size(), "places of other corners");
}

} // namespace esm::fuzz
