#pragma once

#include "core/geometry/polygon_soup.h"
#include "core/geometry/triangle_mesh.h"

#include <cmath>

/// Small surfaces for tests.
namespace esm::test {

/// A cube of six squares facing outwards, each corner its own vertex (24 in all) like in many files.
inline PolygonSoup cubeSoup(double edge = 1, const Eigen::Vector3d& corner = Eigen::Vector3d::Zero()) {
    constexpr int faces[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                 {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    PolygonSoup soup;
    for (const auto& face : faces) {
        std::vector<std::uint32_t> polygon;
        for (const int vertex : face) {
            polygon.push_back(static_cast<std::uint32_t>(soup.vertices.size()));
            soup.vertices.push_back(corner +
                                    edge * Eigen::Vector3d(vertex & 1, vertex >> 1 & 1, vertex >> 2 & 1));
        }
        soup.polygons.push_back(polygon);
    }
    return soup;
}

/// A closed torus around the z axis of rings × sides squares, each split in two.
inline TriangleMesh torus(std::uint32_t rings = 24, std::uint32_t sides = 12, double radius = 1,
                          double tube = 0.3) {
    TriangleMesh mesh;
    const double full = 2 * std::acos(-1.0);
    for (std::uint32_t i = 0; i < rings; ++i)
        for (std::uint32_t j = 0; j < sides; ++j) {
            const double u = full * i / rings, v = full * j / sides, r = radius + tube * std::cos(v);
            mesh.vertices.emplace_back(r * std::cos(u), r * std::sin(u), tube * std::sin(v));
            const std::uint32_t a = i * sides + j, b = i * sides + (j + 1) % sides;
            const std::uint32_t c = (i + 1) % rings * sides + j,
                                d = (i + 1) % rings * sides + (j + 1) % sides;
            mesh.triangles.push_back({a, c, d});
            mesh.triangles.push_back({a, d, b});
        }
    return mesh;
}

inline PolygonSoup soupOf(const TriangleMesh& mesh) {
    PolygonSoup soup;
    soup.vertices = mesh.vertices;
    for (const Triangle& t : mesh.triangles)
        soup.polygons.push_back({t[0], t[1], t[2]});
    return soup;
}

/// A second soup beside the first in the same soup.
inline void append(PolygonSoup& soup, const PolygonSoup& other) {
    const auto first = static_cast<std::uint32_t>(soup.vertices.size());
    soup.vertices.insert(soup.vertices.end(), other.vertices.begin(), other.vertices.end());
    for (std::vector<std::uint32_t> polygon : other.polygons) {
        for (std::uint32_t& vertex : polygon)
            vertex += first;
        soup.polygons.push_back(polygon);
    }
}

} // namespace esm::test
