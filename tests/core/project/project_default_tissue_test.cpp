#include "core/dynamics/measure/scene_run.h"
#include "core/project/project.h"
#include "tests/support/test_surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace esm;

namespace {

TriangleMesh scaled(TriangleMesh mesh, double factor) {
    for (Eigen::Vector3d& vertex : mesh.vertices)
        vertex *= factor;
    return mesh;
}

std::vector<double> areaPerVertex(const TriangleMesh& mesh) {
    std::vector<double> areas(mesh.vertices.size(), 0);
    for (const Triangle& t : mesh.triangles) {
        const Eigen::Vector3d& corner = mesh.vertices[t[0]];
        const double twice = (mesh.vertices[t[1]] - corner).cross(mesh.vertices[t[2]] - corner).norm();
        for (const std::uint32_t vertex : t)
            areas[vertex] += twice / 6;
    }
    return areas;
}

/// An organ of default tissue, one of whose nodes was led by a twentieth of its size along y and held.
struct Poked {
    SceneOutcome outcome;
    double size = 0; ///< diagonal of the bounding box, m
    double patch =
        0; ///< radius of the disc with the area that moved (each part counted by how far), per size
};

Poked poke(const TriangleMesh& mesh, double direction) {
    const Project project = makeProject("organ", {mesh, {}});
    const auto& rest = project.network->restPositions;
    const auto top = std::max_element(rest.begin(), rest.end(),
                                      [](const auto& p, const auto& q) { return p.y() < q.y(); });
    Poked result;
    result.size = boundingBox(rest).diagonal().norm();
    const Eigen::Vector3d way(0, direction * 0.05 * result.size, 0);
    Scene scene = project.scene;
    scene.duration = 2;
    scene.record.every = scene.duration;
    scene.moves = {{static_cast<std::uint32_t>(top - rest.begin()), {{0, {0, 0, 0}}, {0.5, way}}}};
    std::vector<Eigen::Vector3d> last;
    result.outcome =
        runScene({evaluateModel(project), mesh.triangles, scene},
                 [&](double, const std::vector<Eigen::Vector3d>& positions) { last = positions; });
    const std::vector<double> areas = areaPerVertex(mesh);
    double moved = 0;
    for (std::size_t i = 0; i < rest.size(); ++i)
        moved += areas[i] * (last[i] - rest[i]).norm() / way.norm();
    result.patch = std::sqrt(moved / M_PI) / result.size;
    return result;
}

} // namespace

TEST(DefaultTissue, GivesWayOverAPatchOfTheOrgansSize) {
    for (const double direction : {-1.0, 1.0}) {
        const Poked poked = poke(lumpySurface(20, 40), direction);
        EXPECT_TRUE(poked.outcome.stable) << poked.outcome.outcome;
        EXPECT_GT(poked.patch, 0.03) << "only the touched node moves";
        EXPECT_LT(poked.patch, 0.12) << "the whole organ moves";
    }
}

// With the same tethers on both meshes the patches would differ by a factor of three.
TEST(DefaultTissue, GivesWayAlikeOnCoarseAndFineMeshes) {
    for (const double direction : {-1.0, 1.0}) {
        const double coarse = poke(lumpySurface(12, 24), direction).patch;
        const double fine = poke(lumpySurface(36, 72), direction).patch;
        EXPECT_LT(std::max(coarse, fine) / std::min(coarse, fine), 1.5) << coarse << " and " << fine;
    }
}

TEST(DefaultTissue, MovesAlikeAtAnySize) {
    const TriangleMesh mesh = lumpySurface(12, 24);
    const double organ = poke(mesh, 1).patch;
    for (const double factor : {0.001, 0.1, 10.0, 1000.0}) {
        const Poked poked = poke(scaled(mesh, factor), 1);
        EXPECT_TRUE(poked.outcome.stable) << factor << ": " << poked.outcome.outcome;
        EXPECT_NEAR(poked.patch, organ, 0.1 * organ) << factor;
    }
}

TEST(DefaultTissue, IsThePublishedFlexibleTissueForOrgans) {
    for (const double factor : {0.1, 0.5, 1.0}) {
        const Project project = makeProject("organ", {scaled(lumpySurface(12, 24), factor), {}});
        EXPECT_EQ(project.base.springConstant, 16.26) << factor;
        EXPECT_EQ(project.base.viscosity, 2.877) << factor;
    }
}
