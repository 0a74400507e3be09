#pragma once

#include "core/model/tissue_model.h"

#include <cmath>
#include <map>
#include <memory>

/// Small tissues that tests are made of.
namespace tissue {

using esm::TissueModel;
using Vectors = std::vector<Eigen::Vector3d>;

struct Parameters {
    double springConstant = 10; ///< N/m
    double viscosity = 0.1;     ///< N·s/m
    double nodeMass = 0.001;    ///< kg
};

inline TissueModel model(esm::SpringNetwork network, const Parameters& parameters) {
    TissueModel result;
    const std::size_t nodes = network.restPositions.size();
    result.mass.assign(nodes, parameters.nodeMass);
    result.springConstant.assign(nodes, parameters.springConstant);
    result.viscosity.assign(nodes, parameters.viscosity);
    result.network = std::make_shared<const esm::SpringNetwork>(std::move(network));
    return result;
}

inline void addSpring(esm::SpringNetwork& network, std::size_t first, std::size_t second) {
    const double length = (network.restPositions[first] - network.restPositions[second]).norm();
    network.springs.push_back(
        {static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(second), length});
}

/// Two nodes on the x axis, `length` apart.
inline TissueModel oneSpring(const Parameters& parameters, double length = 1) {
    esm::SpringNetwork network;
    network.restPositions = {{0, 0, 0}, {length, 0, 0}};
    addSpring(network, 0, 1);
    return model(std::move(network), parameters);
}

inline esm::TriangleMesh gridMesh(int perSide, double size) {
    esm::TriangleMesh mesh;
    for (int y = 0; y < perSide; ++y)
        for (int x = 0; x < perSide; ++x)
            mesh.vertices.emplace_back(size * (x / (perSide - 1.0) - 0.5), size * (y / (perSide - 1.0) - 0.5),
                                       0);
    const auto node = [perSide](int x, int y) { return static_cast<std::uint32_t>(y * perSide + x); };
    for (int y = 0; y + 1 < perSide; ++y)
        for (int x = 0; x + 1 < perSide; ++x) {
            mesh.triangles.push_back({node(x, y), node(x + 1, y), node(x + 1, y + 1)});
            mesh.triangles.push_back({node(x, y), node(x + 1, y + 1), node(x, y + 1)});
        }
    return mesh;
}

/// An icosahedron whose triangles were quartered `levels` times: 10·4^levels + 2 vertices.
inline esm::TriangleMesh sphereMesh(int levels, double radius) {
    const double g = (1 + std::sqrt(5.0)) / 2;
    esm::TriangleMesh mesh;
    mesh.vertices = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                     {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
    mesh.triangles = {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                      {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                      {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
    for (int level = 0; level < levels; ++level) {
        std::map<esm::Edge, std::uint32_t> middles;
        const auto middle = [&](std::uint32_t a, std::uint32_t b) {
            const auto [it, isNew] = middles.try_emplace(std::minmax(a, b), mesh.vertices.size());
            if (isNew) mesh.vertices.emplace_back((mesh.vertices[a] + mesh.vertices[b]) / 2);
            return it->second;
        };
        std::vector<esm::Triangle> finer;
        for (const auto& [a, b, c] : mesh.triangles) {
            const auto ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
            finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
        }
        mesh.triangles = std::move(finer);
    }
    for (Eigen::Vector3d& vertex : mesh.vertices)
        vertex = vertex.normalized() * radius;
    return mesh;
}

inline TissueModel fromMesh(const esm::TriangleMesh& mesh, const Parameters& parameters) {
    return model(esm::networkFromMesh(mesh), parameters);
}

/// Published fallopian tube [R 5.1, C.1]: 17 rings of 10 nodes, 330 edges and the five diameters of each end
/// ring, 10 g, every third node tethered.
inline TissueModel fallopianTube() {
    constexpr std::size_t rings = 17, around = 10;
    esm::SpringNetwork network;
    for (std::size_t ring = 0; ring < rings; ++ring)
        for (std::size_t i = 0; i < around; ++i) {
            const double angle = 2 * 3.14159265358979323846 * static_cast<double>(i) / around;
            network.restPositions.emplace_back(0.1 * static_cast<double>(ring) / (rings - 1),
                                               0.005 * std::cos(angle), 0.005 * std::sin(angle));
        }
    for (std::size_t ring = 0; ring < rings; ++ring)
        for (std::size_t i = 0; i < around; ++i) {
            addSpring(network, ring * around + i, ring * around + (i + 1) % around);
            if (ring + 1 < rings) addSpring(network, ring * around + i, (ring + 1) * around + i);
        }
    for (std::size_t end : {std::size_t{0}, (rings - 1) * around})
        for (std::size_t i = 0; i < around / 2; ++i)
            addSpring(network, end + i, end + i + around / 2);
    TissueModel tube = model(std::move(network), {16.2606, 2.87713, 0.010 / (rings * around)});
    for (std::uint32_t node = 0; node < rings * around; node += 3)
        tube.tethers.push_back({node, 2.41327, 10.6875});
    return tube;
}

} // namespace tissue
