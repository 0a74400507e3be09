#include "core/exchange/package/page_vertices.h"

#include "core/texture/maps/patch_frame.h"

#include <algorithm>

namespace esm {

namespace {

using TexturePlace = std::array<float, 2>;

TexturePlace placeOf(const Atlas& atlas, std::uint32_t triangle, std::size_t corner) {
    const Eigen::Vector2d place = atlas.corners[triangle][corner] / atlas.options.size;
    return {static_cast<float>(std::clamp(place.x(), 0.0, 1.0)),
            static_cast<float>(std::clamp(place.y(), 0.0, 1.0))};
}

/// Draws corners, those that are alike by one vertex.
class CornerSharing {
public:
    CornerSharing(const Project& project, const std::vector<Eigen::Vector3d>& normals, PageVertices& drawn)
        : m_project(project), m_normals(normals), m_drawn(drawn), m_drawnAs(project.mesh->vertices.size()) {}

    void draw(std::uint32_t triangle) {
        const double handedness = patchFrame(*m_project.mesh, *m_project.atlas, triangle).handedness;
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const TexturePlace place = placeOf(*m_project.atlas, triangle, corner);
            m_drawn.corners.push_back(
                vertexAt(m_project.mesh->triangles[triangle][corner], place, handedness));
        }
    }

private:
    std::uint32_t vertexAt(std::uint32_t vertex, const TexturePlace& place, double handedness) {
        std::vector<std::uint32_t>& known = m_drawnAs[vertex];
        const bool mayShare = isStretched(m_project.atlas->options.layout);
        const auto same = std::find_if(known.begin(), known.end(), [&](std::size_t other) {
            return m_drawn.places[2 * other] == place[0] && m_drawn.places[2 * other + 1] == place[1] &&
                   m_drawn.handedness[other] == handedness;
        });
        if (mayShare && same != known.end()) return *same;
        known.push_back(static_cast<std::uint32_t>(m_drawn.vertices.size()));
        m_drawn.positions.push_back(m_project.mesh->vertices[vertex]);
        m_drawn.normals.push_back(m_normals[vertex]);
        m_drawn.nodes.push_back(m_project.network->vertexNodes[vertex]);
        m_drawn.vertices.push_back(vertex);
        m_drawn.handedness.push_back(handedness);
        m_drawn.places.insert(m_drawn.places.end(), place.begin(), place.end());
        return known.back();
    }

    const Project& m_project;
    const std::vector<Eigen::Vector3d>& m_normals;
    PageVertices& m_drawn;
    std::vector<std::vector<std::uint32_t>> m_drawnAs; ///< per vertex of the surface
};

} // namespace

PageVertices pageVertices(const Project& project, const std::vector<Eigen::Vector3d>& normals,
                          const std::vector<std::uint32_t>& triangles) {
    PageVertices drawn;
    drawn.corners.reserve(3 * triangles.size());
    CornerSharing sharing(project, normals, drawn);
    for (const std::uint32_t triangle : triangles)
        sharing.draw(triangle);
    return drawn;
}

} // namespace esm
