#include "core/texture/atlas/charts/dual_graph.h"

#include "core/geometry/adjacency.h"

#include <algorithm>

namespace esm {

// Charts grow over edges and not over corners, so that each is in one piece that can be laid flat: triangles
// that only touch at a corner could turn about it.
DualGraph dualGraph(const TriangleMesh& mesh, const std::vector<bool>& hasArea) {
    DualGraph graph;
    graph.across = trianglesAcross(mesh.triangles);
    graph.centres.reserve(mesh.triangles.size());
    graph.normals.reserve(mesh.triangles.size());
    graph.areas.reserve(mesh.triangles.size());
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const Triangle& at = mesh.triangles[i];
        for (std::uint32_t& next : graph.across[i])
            if (next != noIndex && !(hasArea[i] && hasArea[next])) next = noIndex;
        const Eigen::Vector3d normal = areaNormal(mesh.vertices, at);
        graph.centres.emplace_back((mesh.vertices[at[0]] + mesh.vertices[at[1]] + mesh.vertices[at[2]]) / 3);
        graph.normals.push_back(hasArea[i] ? normal.normalized() : Eigen::Vector3d::Zero());
        graph.areas.push_back(hasArea[i] ? normal.norm() / 2 : 0);
    }
    return graph;
}

DualGraph partOf(const DualGraph& whole, const std::vector<std::uint32_t>& triangles) {
    DualGraph part;
    part.across.reserve(triangles.size());
    part.centres.reserve(triangles.size());
    part.normals.reserve(triangles.size());
    part.areas.reserve(triangles.size());
    for (const std::uint32_t triangle : triangles) {
        Triangle& across = part.across.emplace_back(whole.across[triangle]);
        for (std::uint32_t& next : across) {
            const auto found = std::lower_bound(triangles.begin(), triangles.end(), next);
            next = found != triangles.end() && *found == next
                       ? static_cast<std::uint32_t>(found - triangles.begin())
                       : noIndex;
        }
        part.centres.push_back(whole.centres[triangle]);
        part.normals.push_back(whole.normals[triangle]);
        part.areas.push_back(whole.areas[triangle]);
    }
    return part;
}

} // namespace esm
