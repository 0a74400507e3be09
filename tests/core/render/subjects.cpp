#include "tests/core/render/subjects.h"

#include "core/support/angles.h"

#include <algorithm>
#include <cmath>

namespace esm {

TriangleMesh ball(int rings, int sectors, double bump) {
    TriangleMesh mesh;
    const auto add = [&](double polar, double around) {
        const Eigen::Vector3d unit(std::sin(polar) * std::sin(around), std::cos(polar),
                                   std::sin(polar) * std::cos(around));
        mesh.vertices.push_back(unit * (1 + bump * std::sin(2 * around + unit.y()) * std::sin(polar) +
                                        bump * unit.x() * unit.y()));
    };
    add(0, 0);
    for (int ring = 1; ring < rings; ++ring)
        for (int sector = 0; sector < sectors; ++sector)
            add(pi * ring / rings, 2 * pi * sector / sectors);
    add(pi, 0);
    const auto last = static_cast<std::uint32_t>(mesh.vertices.size() - 1);
    const auto at = [&](int ring, int sector) {
        return static_cast<std::uint32_t>(1 + (ring - 1) * sectors + sector % sectors);
    };
    for (int sector = 0; sector < sectors; ++sector) {
        mesh.triangles.push_back({0, at(1, sector), at(1, sector + 1)});
        for (int ring = 1; ring < rings - 1; ++ring) {
            mesh.triangles.push_back({at(ring, sector), at(ring + 1, sector), at(ring, sector + 1)});
            mesh.triangles.push_back({at(ring, sector + 1), at(ring + 1, sector), at(ring + 1, sector + 1)});
        }
        mesh.triangles.push_back({last, at(rings - 1, sector + 1), at(rings - 1, sector)});
    }
    return mesh;
}

RenderScene texturedSquare(const Image& picture) {
    TriangleMesh mesh;
    mesh.vertices = {{-0.5, -0.5, 0}, {0.5, -0.5, 0}, {0.5, 0.5, 0}, {-0.5, 0.5, 0}};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    const double size = picture.width;
    Atlas atlas;
    atlas.options.size = picture.width;
    atlas.corners = {{{{0, size}, {size, size}, {size, 0}}}, {{{0, size}, {size, 0}, {0, 0}}}};
    atlas.page = {0, 0};
    RenderScene scene;
    scene.mesh = std::make_shared<TriangleMesh>(mesh);
    scene.atlas = std::make_shared<Atlas>(atlas);
    scene.texturePages = std::make_shared<TiledPages>(tiled({picture}));
    return scene;
}

Image quarters(int size) {
    Image image;
    image.width = image.height = size;
    image.pixels.resize(static_cast<std::size_t>(4 * size * size));
    const std::array<std::array<std::uint8_t, 4>, 4> colours{
        {{200, 40, 30, 255}, {30, 180, 60, 255}, {40, 60, 210, 255}, {128, 128, 128, 255}}};
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            const std::size_t quarter = (x < size / 2 ? 0U : 1U) + (y < size / 2 ? 0U : 2U);
            std::copy(colours[quarter].begin(), colours[quarter].end(), image.at(x, y));
        }
    return image;
}

std::shared_ptr<const SpringNetwork> edgeNetwork(const TriangleMesh& mesh) {
    auto network = std::make_shared<SpringNetwork>();
    network->restPositions = mesh.vertices;
    for (const Edge& edge : uniqueEdges(mesh.triangles))
        network->springs.push_back(
            {edge.first, edge.second, (mesh.vertices[edge.first] - mesh.vertices[edge.second]).norm()});
    for (std::uint32_t i = 0; i < mesh.vertices.size(); ++i)
        network->vertexNodes.push_back(i);
    return network;
}

} // namespace esm
