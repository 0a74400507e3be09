#include "core/exchange/package/page_vertices.h"

#include <algorithm>

namespace esm {

PageVertices pageVertices(const Project& project, const std::vector<Eigen::Vector3d>& normals,
                          const std::vector<std::uint32_t>& triangles) {
    const Atlas& atlas = *project.atlas;
    PageVertices drawn;
    drawn.vertices.reserve(3 * triangles.size());
    for (const std::uint32_t triangle : triangles)
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const std::uint32_t vertex = project.mesh->triangles[triangle][corner];
            drawn.positions.push_back(project.mesh->vertices[vertex]);
            drawn.normals.push_back(normals[vertex]);
            drawn.nodes.push_back(project.network->vertexNodes[vertex]);
            drawn.vertices.push_back(vertex);
            const Eigen::Vector2d place = atlas.corners[triangle][corner] / atlas.options.size;
            for (const double value : {place.x(), place.y()})
                drawn.places.push_back(static_cast<float>(std::clamp(value, 0.0, 1.0)));
        }
    return drawn;
}

} // namespace esm
