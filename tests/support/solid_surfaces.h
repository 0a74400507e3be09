#pragma once

#include "tests/support/test_meshes.h"
#include "tests/support/test_surfaces.h"

#include <cmath>

/// Surfaces to fill, or to put a wall beneath.
namespace esm::test {

inline void append(TriangleMesh& mesh, const TriangleMesh& other) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), other.vertices.begin(), other.vertices.end());
    for (const Triangle& t : other.triangles)
        mesh.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
}

inline TriangleMesh turned(TriangleMesh mesh) {
    for (Triangle& triangle : mesh.triangles)
        std::swap(triangle[1], triangle[2]);
    return mesh;
}

/// A ball of rings and segments, facing outwards.
inline TriangleMesh ball(double radius, const Eigen::Vector3d& centre, int rings = 24) {
    TriangleMesh mesh = lumpySurface(rings, 2 * rings);
    for (Eigen::Vector3d& vertex : mesh.vertices) {
        vertex.y() /= 0.6;
        vertex = centre + radius * vertex.normalized();
    }
    return mesh;
}

/// A ball with a cavity in its middle.
inline TriangleMesh shell(double outer, double inner) {
    TriangleMesh mesh = ball(outer, Eigen::Vector3d::Zero());
    append(mesh, turned(ball(inner, Eigen::Vector3d::Zero())));
    return mesh;
}

/// A block from one corner to another.
inline TriangleMesh block(const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
    TriangleMesh mesh;
    for (int corner = 0; corner < 8; ++corner)
        mesh.vertices.emplace_back(corner & 1 ? to.x() : from.x(), corner >> 1 & 1 ? to.y() : from.y(),
                                   corner >> 2 & 1 ? to.z() : from.z());
    constexpr std::uint32_t faces[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                           {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    for (const auto& face : faces) {
        mesh.triangles.push_back({face[0], face[1], face[2]});
        mesh.triangles.push_back({face[0], face[2], face[3]});
    }
    return mesh;
}

/// Open at both ends, facing outwards, along z.
inline TriangleMesh openTube(double radius, double length, std::uint32_t rings, std::uint32_t sides) {
    TriangleMesh mesh;
    for (std::uint32_t ring = 0; ring <= rings; ++ring)
        for (std::uint32_t side = 0; side < sides; ++side) {
            const double around = 2 * M_PI * (side + 0.5 * (ring % 2)) / sides;
            mesh.vertices.emplace_back(radius * std::cos(around), radius * std::sin(around),
                                       length * ring / rings);
        }
    for (std::uint32_t ring = 0; ring < rings; ++ring)
        for (std::uint32_t side = 0; side < sides; ++side) {
            const std::uint32_t next = (side + 1) % sides, shift = ring % 2;
            const auto at = [&](std::uint32_t up, std::uint32_t i) { return (ring + up) * sides + i; };
            mesh.triangles.push_back({at(0, side), at(0, next), at(1, shift ? next : side)});
            mesh.triangles.push_back({at(0, shift ? side : next), at(1, next), at(1, side)});
        }
    return mesh;
}

} // namespace esm::test
