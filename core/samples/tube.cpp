#include "core/samples/organs.h"

#include "core/support/angles.h"

#include <cmath>

namespace esm {

namespace {

constexpr std::uint32_t ringCount = 17, ringNodes = 10;
std::uint32_t nodeAt(std::uint32_t ring, std::uint32_t around) {
    return ring * ringNodes + around % ringNodes;
}

/// The centre line, m, from the uterus (0) to the ovary (1): about 10 cm, gently curved.
Eigen::Vector3d centreAt(double t) {
    return {0.096 * (t - 0.5), 0.013 * std::sin(pi * t) - 0.012 * t * t, 0.006 * std::sin(2 * pi * t)};
}

/// A high power keeps the tube even and opens it only near its end.
/// Narrow at the uterus, wider towards the ovary, where the end opens like a funnel with a wavy seam.
double radiusAt(double t, std::uint32_t around) {
    const double funnel = std::pow(t, 8);
    const double seam = 1 + 0.05 * funnel * (around % 2 == 0 ? 1 : -1);
    return (0.0028 + 0.0022 * t + 0.0045 * funnel) * seam;
}

TriangleMesh tubeSurface() {
    TriangleMesh mesh;
    for (std::uint32_t ring = 0; ring < ringCount; ++ring) {
        const double t = double(ring) / (ringCount - 1);
        const Eigen::Vector3d along = (centreAt(t + 1e-4) - centreAt(t - 1e-4)).normalized();
        const Eigen::Vector3d front = (Eigen::Vector3d::UnitZ() - along.z() * along).normalized();
        const Eigen::Vector3d up = front.cross(along);
        for (std::uint32_t around = 0; around < ringNodes; ++around) {
            const double angle = 2 * pi * around / ringNodes;
            mesh.vertices.emplace_back(centreAt(t) + radiusAt(t, around) *
                                                         (std::cos(angle) * front + std::sin(angle) * up));
        }
    }
    for (std::uint32_t ring = 0; ring + 1 < ringCount; ++ring)
        for (std::uint32_t around = 0; around < ringNodes; ++around) {
            const std::uint32_t a = nodeAt(ring, around), b = nodeAt(ring + 1, around);
            const std::uint32_t c = nodeAt(ring + 1, around + 1), d = nodeAt(ring, around + 1);
            mesh.triangles.push_back({a, b, c});
            mesh.triangles.push_back({a, c, d});
        }
    return mesh;
}

/// Springs around and along the tube, none across the squares [R fig. 4.2], and the diameters that keep its
/// open ends round.
SpringNetwork tubeNetwork(const TriangleMesh& mesh) {
    SpringNetwork network = networkFromMesh(mesh);
    network.springs.clear();
    const auto tie = [&](std::uint32_t first, std::uint32_t second) {
        network.springs.push_back({first, second, (mesh.vertices[first] - mesh.vertices[second]).norm()});
    };
    for (std::uint32_t ring = 0; ring < ringCount; ++ring)
        for (std::uint32_t around = 0; around < ringNodes; ++around)
            tie(nodeAt(ring, around), nodeAt(ring, around + 1));
    for (std::uint32_t ring = 0; ring + 1 < ringCount; ++ring)
        for (std::uint32_t around = 0; around < ringNodes; ++around)
            tie(nodeAt(ring, around), nodeAt(ring + 1, around));
    for (const std::uint32_t ring : {0U, ringCount - 1})
        for (std::uint32_t around = 0; around < ringNodes / 2; ++around)
            tie(nodeAt(ring, around), nodeAt(ring, around + ringNodes / 2));
    return network;
}

} // namespace

Project makeTube() {
    Project project = makeProject("Fallopian tube", asImported(tubeSurface()), 0.010);
    project.network = std::make_shared<const SpringNetwork>(tubeNetwork(*project.mesh));
    project.regions = {fuzzyRegion("Tube", "susilap-g", {{"consistency", 5.5}})};
    project.scene.duration = 3;
    project.scene.tethers = {{3, 2.41327, 10.6875}}; // consistency 2.5 [R C.1]
    project.scene.instruments = {
        pokeOf(*project.mesh, {{centreAt(0.5) + 0.1 * Eigen::Vector3d::UnitZ(), -Eigen::Vector3d::UnitZ()},
                               0.005,
                               0.008,
                               project.scene.duration})};
    return project;
}

} // namespace esm
