#include "core/exchange/meshes/mesh_stream.h"

#include <algorithm>
#include <limits>

namespace esm {

namespace {

static_assert(sizeof(Eigen::Vector3d) == 3 * sizeof(double), "points are written as they lie in memory");
static_assert(sizeof(Eigen::Vector2d) == 2 * sizeof(double), "as are places");

struct SoupCounts {
    std::uint64_t vertices = 0, polygons = 0, corners = 0;
    std::uint64_t placed = 0; ///< polygons whose places are told: all or 0
};

bool isSurface(const SoupCounts& counts, const std::vector<std::uint32_t>& sizes) {
    std::uint64_t corners = 0;
    for (const std::uint32_t size : sizes)
        corners += size;
    const bool arePolygons =
        std::all_of(sizes.begin(), sizes.end(), [](std::uint32_t size) { return size >= 3; });
    return counts.polygons > 0 && arePolygons && corners == counts.corners &&
           counts.vertices <= std::numeric_limits<std::uint32_t>::max();
}

void writePlaces(const PolygonSoup& soup, DecodedWriter& writer) {
    std::vector<std::uint32_t> sizes;
    sizes.reserve(soup.textureCoordinates.size());
    for (const auto& places : soup.textureCoordinates)
        sizes.push_back(static_cast<std::uint32_t>(places.size()));
    writer.array(sizes.data(), sizes.size());
    for (const auto& places : soup.textureCoordinates)
        writer.array(places.data(), places.size());
}

/// Precondition: the polygons are read.
void readPlaces(DecodedStream& stream, PolygonSoup& soup) {
    const auto sizes = stream.array<std::uint32_t>(soup.polygons.size());
    soup.textureCoordinates.reserve(sizes.size());
    for (std::size_t i = 0; i < sizes.size(); ++i) {
        if (sizes[i] != 0 && sizes[i] != soup.polygons[i].size()) stream.failAsNonsense();
        soup.textureCoordinates.push_back(stream.array<Eigen::Vector2d>(sizes[i]));
        for (const Eigen::Vector2d& place : soup.textureCoordinates.back())
            if (!place.allFinite()) stream.failAsNonsense();
    }
}

} // namespace

void writeSoup(const PolygonSoup& soup, DecodedWriter& writer) {
    SoupCounts counts{soup.vertices.size(), soup.polygons.size(), 0, soup.textureCoordinates.size()};
    std::vector<std::uint32_t> sizes;
    sizes.reserve(soup.polygons.size());
    for (const auto& polygon : soup.polygons) {
        sizes.push_back(static_cast<std::uint32_t>(polygon.size()));
        counts.corners += polygon.size();
    }
    writer.value(counts);
    writer.array(soup.vertices.data(), soup.vertices.size());
    writer.array(sizes.data(), sizes.size());
    for (const auto& polygon : soup.polygons)
        writer.array(polygon.data(), polygon.size());
    writePlaces(soup, writer);
}

PolygonSoup readSoup(DecodedStream& stream) {
    const auto counts = stream.value<SoupCounts>();
    PolygonSoup soup;
    soup.vertices = stream.array<Eigen::Vector3d>(counts.vertices);
    const auto sizes = stream.array<std::uint32_t>(counts.polygons);
    if (!isSurface(counts, sizes)) stream.failAsNonsense();
    const auto corners = stream.array<std::uint32_t>(counts.corners);
    const bool areVertices = std::all_of(corners.begin(), corners.end(),
                                         [&](std::uint32_t corner) { return corner < counts.vertices; });
    const bool areFinite = std::all_of(soup.vertices.begin(), soup.vertices.end(),
                                       [](const Eigen::Vector3d& vertex) { return vertex.allFinite(); });
    if (!areVertices || !areFinite) stream.failAsNonsense();
    soup.polygons.reserve(sizes.size());
    auto corner = corners.begin();
    for (const std::uint32_t size : sizes) {
        soup.polygons.emplace_back(corner, corner + size);
        corner += size;
    }
    if (counts.placed == counts.polygons)
        readPlaces(stream, soup);
    else if (counts.placed > 0)
        stream.failAsNonsense();
    if (stream.left() > 0) stream.failAsNonsense();
    return soup;
}

} // namespace esm
