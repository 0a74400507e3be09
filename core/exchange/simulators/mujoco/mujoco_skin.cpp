#include "core/exchange/simulators/mujoco/mujoco_skin.h"

#include "core/exchange/package/page_vertices.h"
#include "core/exchange/simulators/obj_surface.h"
#include "core/support/numbers.h"

#include <numeric>

namespace esm {

namespace {

/// What one skin shows.
struct SkinVertices {
    std::vector<Eigen::Vector3d> positions; ///< m
    std::vector<double> places;             ///< in the texture, two per vertex; empty without
    std::vector<std::uint32_t> vertices;    ///< of the surface
    std::vector<std::uint32_t> corners;     ///< three per triangle
};

SkinVertices wholeSurface(const TriangleMesh& mesh) {
    SkinVertices skin{mesh.vertices, {}, std::vector<std::uint32_t>(mesh.vertices.size()), {}};
    std::iota(skin.vertices.begin(), skin.vertices.end(), 0U);
    for (const Triangle& triangle : mesh.triangles)
        skin.corners.insert(skin.corners.end(), triangle.begin(), triangle.end());
    return skin;
}

SkinVertices pageOfSurface(const Project& project, const std::vector<Eigen::Vector3d>& normals,
                           std::size_t page) {
    std::vector<std::uint32_t> triangles;
    for (std::uint32_t triangle = 0; triangle < project.mesh->triangles.size(); ++triangle)
        if (project.atlas->page[triangle] == page) triangles.push_back(triangle);
    PageVertices drawn = pageVertices(project, normals, triangles, WithTangents::No);
    return {std::move(drawn.positions),
            {drawn.places.begin(), drawn.places.end()},
            std::move(drawn.vertices),
            std::move(drawn.corners)};
}

/// The vertices that a node carries, and its share in each.
struct SkinBone {
    std::vector<std::uint32_t> vertices;
    std::vector<double> shares;
};

std::vector<SkinBone> bonesOf(const SpringNetwork& network, const SkinVertices& skin) {
    std::vector<SkinBone> bones(network.restPositions.size());
    const auto add = [&](std::uint32_t node, std::uint32_t vertex, double share) {
        if (share == 0) return;
        bones[node].vertices.push_back(vertex);
        bones[node].shares.push_back(share);
    };
    for (std::uint32_t vertex = 0; vertex < skin.vertices.size(); ++vertex) {
        const std::uint32_t carried = skin.vertices[vertex];
        if (!network.binding) {
            add(network.vertexNodes[carried], vertex, 1);
            continue;
        }
        const auto& [nodes, shares] = network.binding->vertices[carried];
        for (std::size_t i = 0; i < nodes.size(); ++i)
            add(nodes[i], vertex, shares[i]);
    }
    return bones;
}

void addSkin(const SpringNetwork& network, const SkinVertices& skin, const std::string& material,
             XmlText& xml) {
    XmlAttributes attributes{{"name", material},
                             {"material", material},
                             {"vertex", spaced(skin.positions)},
                             {"face", spaced(skin.corners)}};
    if (!skin.places.empty()) attributes.emplace_back("texcoord", spaced(skin.places));
    xml.open("skin", attributes);
    const std::vector<SkinBone> bones = bonesOf(network, skin);
    for (std::uint32_t node = 0; node < bones.size(); ++node)
        if (!bones[node].vertices.empty())
            xml.add("bone", {{"body", mujocoBodyName(node)},
                             {"bindpos", spaced(network.restPositions[node])},
                             {"bindquat", "1 0 0 0"},
                             {"vertid", spaced(bones[node].vertices)},
                             {"vertweight", spaced(bones[node].shares)}});
    xml.close();
}

std::string skinColour(const TextureSettings& texture) {
    std::string text;
    for (const std::uint8_t channel : texture.baseColour)
        text += roundedText(channel / 255.0) + ' ';
    return text + '1';
}

void addPageSkins(const Handover& handover, XmlText& xml) {
    const Project& project = handover.project;
    const std::vector<Eigen::Vector3d> normals =
        vertexNormals(project.mesh->vertices, project.mesh->triangles);
    for (std::size_t page = 0; page < texturePages(project); ++page) {
        const SkinVertices skin = pageOfSurface(project, normals, page);
        if (skin.corners.empty()) continue;
        const std::string name = "page" + std::to_string(page + 1);
        xml.add("texture", {{"name", name}, {"type", "2d"}, {"file", textureName(page, PictureFormat::Png)}});
        xml.add("material", {{"name", name}, {"texture", name}});
        addSkin(*handover.tissue.network, skin, name, xml);
    }
}

} // namespace

std::string mujocoBodyName(std::uint32_t node) {
    return "node" + std::to_string(node);
}

void addMujocoSkins(const Handover& handover, XmlText& xml) {
    const Project& project = handover.project;
    if (project.mesh->triangles.empty()) return;
    xml.open("asset", {});
    if (project.atlas) {
        addPageSkins(handover, xml);
    } else {
        xml.add("material", {{"name", "surface"}, {"rgba", skinColour(project.texture)}});
        addSkin(*handover.tissue.network, wholeSurface(*project.mesh), "surface", xml);
    }
    xml.close();
}

} // namespace esm
