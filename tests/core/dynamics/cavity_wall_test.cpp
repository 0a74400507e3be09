#include "core/dynamics/cavity_wall.h"
#include "core/dynamics/kernel/thread_team.h"
#include "tests/support/test_meshes.h"
#include "tests/support/tissue_models.h"

#include <gtest/gtest.h>

#include <numeric>

using namespace esm;
using Eigen::Vector3d;
using tissue::Vectors;

namespace {

/// A torus whose nodes stand off it by a tenth of its tube, far from the origin.
TriangleMesh dentedTorus() {
    TriangleMesh mesh = test::torus();
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        const auto x = static_cast<double>(i);
        mesh.vertices[i] += 0.03 * Vector3d(std::sin(3.1 * x), std::cos(1.7 * x), std::sin(0.9 * x));
        mesh.vertices[i] += Vector3d(10, -20, 30);
    }
    return mesh;
}

Vectors someDirections(std::size_t count) {
    Vectors directions;
    for (std::size_t i = 0; i < count; ++i)
        directions.emplace_back(std::cos(2.3 * static_cast<double>(i)),
                                std::sin(1.1 * static_cast<double>(i)),
                                std::cos(0.7 * static_cast<double>(i)));
    return directions;
}

Vectors moved(const Vectors& places, double way, const Vectors& directions) {
    Vectors result = places;
    for (std::size_t i = 0; i < result.size(); ++i)
        result[i] += way * directions[i];
    return result;
}

double product(const Vectors& a, const Vectors& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        sum += a[i].dot(b[i]);
    return sum;
}

} // namespace

TEST(CavityWall, EnclosesTheSurfacesVolume) {
    const TriangleMesh mesh = dentedTorus();
    const CavityWall wall(mesh.triangles);
    EXPECT_NEAR(volumeOf(wall, placesOf(wall, mesh.vertices)).volume, enclosedVolume(mesh),
                1e-12 * enclosedVolume(mesh));
}

TEST(CavityWall, HasTheVolumesGradientAndTheGradientsChange) {
    const TriangleMesh mesh = dentedTorus();
    const CavityWall wall(mesh.triangles);
    const Vectors places = placesOf(wall, mesh.vertices), directions = someDirections(places.size());
    constexpr double small = 1e-5;
    const CavityVolume before = volumeOf(wall, moved(places, -small, directions)),
                       after = volumeOf(wall, moved(places, small, directions));
    const double slope = (after.volume - before.volume) / (2 * small);
    EXPECT_NEAR(product(volumeOf(wall, places).gradient, directions), slope, 1e-7 * std::abs(slope));
    const Vectors change = gradientChange(wall, places, directions);
    for (std::size_t i = 0; i < change.size(); ++i)
        EXPECT_LT((change[i] - (after.gradient[i] - before.gradient[i]) / (2 * small)).norm(), 1e-7);
}

// A pressure can neither push a closed part away nor turn it.
TEST(CavityWall, PressesWithoutForceOrMomentAsAWhole) {
    const TriangleMesh mesh = dentedTorus();
    const CavityWall wall(mesh.triangles);
    const Vectors places = placesOf(wall, mesh.vertices), gradient = volumeOf(wall, places).gradient;
    Vector3d force = Vector3d::Zero(), moment = Vector3d::Zero();
    double sizes = 0;
    for (std::size_t i = 0; i < places.size(); ++i) {
        force += gradient[i];
        moment += (places[i] - places.front()).cross(gradient[i]);
        sizes += gradient[i].norm();
    }
    EXPECT_LT(force.norm(), 1e-13 * sizes);
    EXPECT_LT(moment.norm(), 1e-13 * sizes);
}

TEST(CavityWall, KnowsItsNodesWhateverTheirNumbers) {
    TriangleMesh mesh = tissue::sphereMesh(1, 1);
    const auto count = static_cast<std::uint32_t>(mesh.vertices.size());
    Vectors positions(2 * count, Vector3d::Constant(1e3));
    for (std::uint32_t i = 0; i < count; ++i)
        positions[2 * count - 1 - 2 * i] = mesh.vertices[i];
    std::vector<Triangle> triangles;
    for (const auto& [a, b, c] : mesh.triangles)
        triangles.push_back({2 * count - 1 - 2 * a, 2 * count - 1 - 2 * b, 2 * count - 1 - 2 * c});
    const CavityWall wall(triangles);
    EXPECT_EQ(wall.size(), count);
    EXPECT_NEAR(volumeOf(wall, placesOf(wall, positions)).volume, enclosedVolume(mesh), 1e-12);
}

TEST(CavityWall, IsTheSameWithAnyNumberOfThreads) {
    const TriangleMesh mesh = tissue::sphereMesh(4, 0.7);
    const CavityWall wall(mesh.triangles);
    const Vectors places = moved(placesOf(wall, mesh.vertices), 0.01, someDirections(wall.size()));
    const CavityVolume alone = volumeOf(wall, places);
    for (const std::size_t threads : {2U, 3U, 5U}) {
        ThreadTeam team(threads);
        const CavityVolume shared = volumeOf(wall, places, &team);
        EXPECT_EQ(shared.volume, alone.volume) << threads;
        EXPECT_EQ(shared.gradient, alone.gradient) << threads;
    }
}
