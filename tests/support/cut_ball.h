#pragma once

#include "core/geometry/triangle_mesh.h"

#include <algorithm>
#include <cmath>
#include <vector>

/// Balls that were cut open, for tests of repair.
namespace esm::test {

struct BallShape {
    std::uint32_t rings = 60, segments = 120; ///< of a globe, from pole to pole and around
    double radius = 0.06;                     ///< m
};

/// A closed globe around the y axis.
inline TriangleMesh ball(const BallShape& shape = {}) {
    TriangleMesh mesh;
    const auto add = [&](std::uint32_t ring, std::uint32_t segment) {
        const double polar = M_PI * ring / shape.rings, around = 2 * M_PI * segment / shape.segments;
        mesh.vertices.emplace_back(shape.radius * std::sin(polar) * std::cos(around),
                                   shape.radius * std::cos(polar),
                                   -shape.radius * std::sin(polar) * std::sin(around));
    };
    add(0, 0);
    for (std::uint32_t ring = 1; ring < shape.rings; ++ring)
        for (std::uint32_t segment = 0; segment < shape.segments; ++segment)
            add(ring, segment);
    add(shape.rings, 0);
    const auto last = static_cast<std::uint32_t>(mesh.vertices.size() - 1);
    const auto index = [&](std::uint32_t ring, std::uint32_t segment) {
        if (ring == 0) return std::uint32_t{0};
        return ring == shape.rings ? last : 1 + (ring - 1) * shape.segments + segment % shape.segments;
    };
    for (std::uint32_t ring = 0; ring < shape.rings; ++ring)
        for (std::uint32_t segment = 0; segment < shape.segments; ++segment) {
            const std::uint32_t a = index(ring, segment), b = index(ring + 1, segment);
            const std::uint32_t c = index(ring + 1, segment + 1), d = index(ring, segment + 1);
            if (ring + 1 < shape.rings) mesh.triangles.push_back({a, b, c});
            if (ring > 0) mesh.triangles.push_back({a, c, d});
        }
    return mesh;
}

/// A cut along a ring of a globe.
struct RingCut {
    std::uint32_t ring = 30;             ///< from the pole at +y
    std::uint32_t first = 0, edges = 81; ///< segment where it begins, and how many it takes
    double gap = 6e-4;                   ///< m
    double sway = 0;                     ///< m, by which the line of the cut leaves the ring to and fro
};

struct CutMesh {
    TriangleMesh mesh;
    std::vector<std::uint32_t> upper, lower; ///< vertices on both sides, those across from each other in turn
};

/// Opens a surface along a part of a ring; both ends stay closed.
inline CutMesh cutOpen(TriangleMesh mesh, const BallShape& shape, const RingCut& cut) {
    CutMesh open{std::move(mesh), {}, {}};
    std::vector<std::uint32_t> copies(open.mesh.vertices.size(), noIndex);
    for (std::uint32_t step = 1; step < cut.edges; ++step) {
        const std::uint32_t vertex =
            1 + (cut.ring - 1) * shape.segments + (cut.first + step) % shape.segments;
        const double sway = step % 2 ? cut.sway : -cut.sway;
        const Eigen::Vector3d middle = open.mesh.vertices[vertex] + Eigen::Vector3d(0, sway, 0);
        open.mesh.vertices[vertex] = middle + Eigen::Vector3d(0, cut.gap / 2, 0);
        copies[vertex] = static_cast<std::uint32_t>(open.mesh.vertices.size());
        open.upper.push_back(vertex);
        open.lower.push_back(copies[vertex]);
        open.mesh.vertices.push_back(middle - Eigen::Vector3d(0, cut.gap / 2, 0));
    }
    const double height = shape.radius * std::cos(M_PI * cut.ring / shape.rings);
    for (Triangle& triangle : open.mesh.triangles) {
        double centre = 0;
        for (const std::uint32_t vertex : triangle)
            centre += open.mesh.vertices[vertex].y() / 3;
        if (centre > height) continue;
        for (std::uint32_t& vertex : triangle)
            if (vertex < copies.size() && copies[vertex] != noIndex) vertex = copies[vertex];
    }
    return open;
}

inline CutMesh cutBall(const RingCut& cut = {}, const BallShape& shape = {}) {
    return cutOpen(ball(shape), shape, cut);
}

/// Draws every so many of the lower side's vertices onto the one before, which leaves triangles of no area.
inline void thinOut(CutMesh& cut, std::size_t every) {
    for (std::size_t i = every; i < cut.lower.size(); i += every)
        for (Triangle& triangle : cut.mesh.triangles)
            std::replace(triangle.begin(), triangle.end(), cut.lower[i], cut.lower[i - 1]);
}

} // namespace esm::test
