#include "core/exchange/package/page_vertices.h"

#include "core/texture/maps/patch_frame.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <map>
#include <tuple>

namespace esm {

namespace {

/// What corners that share a vertex have in common.
struct DrawnPlace {
    std::uint32_t vertex;
    std::array<float, 2> place;
    double handedness; ///< 1 or −1; 0 where it does not matter

    bool operator<(const DrawnPlace& other) const {
        return std::tie(vertex, place, handedness) < std::tie(other.vertex, other.place, other.handedness);
    }
};

std::array<float, 2> placeOf(const Atlas& atlas, std::uint32_t triangle, std::size_t corner) {
    const Eigen::Vector2d place = atlas.corners[triangle][corner] / atlas.options.size;
    return {static_cast<float>(std::clamp(place.x(), 0.0, 1.0)),
            static_cast<float>(std::clamp(place.y(), 0.0, 1.0))};
}

/// At right angles to the normal, whatever the tangent is.
Eigen::Vector3d across(const Eigen::Vector3d& normal, const Eigen::Vector3d& tangent) {
    const Eigen::Vector3d upright = tangent - normal * normal.dot(tangent);
    const double length = upright.norm();
    return length > 1e-6 ? Eigen::Vector3d(upright / length) : normal.unitOrthogonal();
}

class PageDrawing {
public:
    PageDrawing(const Project& project, const std::vector<Eigen::Vector3d>& normals, WithTangents tangents)
        : m_project(project), m_normals(normals), m_withTangents(tangents == WithTangents::Yes) {}

    void draw(std::uint32_t triangle) {
        const TriangleMesh& mesh = *m_project.mesh;
        const auto frame =
            m_withTangents ? patchFrame(mesh, *m_project.atlas, triangle) : std::optional<PatchFrame>();
        const double handedness = frame ? frame->handedness : m_withTangents ? 1 : 0;
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const std::uint32_t drawn = vertexAt(
                {mesh.triangles[triangle][corner], placeOf(*m_project.atlas, triangle, corner), handedness});
            m_drawn.corners.push_back(drawn);
            if (frame) m_sides[drawn].tangents += frame->tangent;
        }
    }

    PageVertices result() && {
        for (std::size_t i = 0; m_withTangents && i < m_sides.size(); ++i) {
            const Eigen::Vector3d tangent = across(m_drawn.normals[i], m_sides[i].tangents);
            for (const double value : {tangent.x(), tangent.y(), tangent.z(), m_sides[i].handedness})
                m_drawn.tangents.push_back(static_cast<float>(value));
        }
        return std::move(m_drawn);
    }

private:
    /// Of a drawn vertex: the sum of the tangents of what shares it, and whether that is mirrored.
    struct Side {
        Eigen::Vector3d tangents = Eigen::Vector3d::Zero();
        double handedness = 1;
    };

    std::uint32_t vertexAt(const DrawnPlace& at) {
        const auto next = static_cast<std::uint32_t>(m_drawn.vertices.size());
        if (isStretched(m_project.atlas->options.layout)) {
            const auto [known, isNew] = m_known.try_emplace(at, next);
            if (!isNew) return known->second;
        }
        m_drawn.positions.push_back(m_project.mesh->vertices[at.vertex]);
        m_drawn.normals.push_back(m_normals[at.vertex]);
        m_drawn.nodes.push_back(m_project.network->vertexNodes[at.vertex]);
        m_drawn.vertices.push_back(at.vertex);
        m_drawn.places.insert(m_drawn.places.end(), at.place.begin(), at.place.end());
        m_sides.push_back({Eigen::Vector3d::Zero(), at.handedness});
        return next;
    }

    const Project& m_project;
    const std::vector<Eigen::Vector3d>& m_normals;
    bool m_withTangents;
    PageVertices m_drawn;
    std::vector<Side> m_sides; ///< of each drawn vertex
    std::map<DrawnPlace, std::uint32_t> m_known;
};

} // namespace

PageVertices pageVertices(const Project& project, const std::vector<Eigen::Vector3d>& normals,
                          const std::vector<std::uint32_t>& triangles, WithTangents withTangents) {
    PageDrawing drawing(project, normals, withTangents);
    for (const std::uint32_t triangle : triangles)
        drawing.draw(triangle);
    return std::move(drawing).result();
}

} // namespace esm
