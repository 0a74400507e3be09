#include "core/project/detail_change.h"

#include "core/dynamics/simulation.h"
#include "core/support/errors.h"
#include "tests/support/solid_surfaces.h"
#include "tests/support/steady_progress.h"
#include "tests/support/was_touched.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

namespace esm {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

constexpr double radius = 0.03;

Project hollowBall() {
    return makeProject("ball", {test::ball(radius, {0.1, 0, 0}), {}}, 0.1, {});
}

Detail filledBy(double spacing) {
    return {Detail::Kind::Filled, 0, LatticeFilling{LatticeKind::BodyCentred, spacing}};
}

TEST(FilledOrgan, IsSoundAndSaysWhatFillsIt) {
    const Project hollow = hollowBall(), solid = withDetail(hollow, filledBy(0.008));
    EXPECT_THAT(validate(solid), IsEmpty());
    const Detail detail = detailOf(*solid.network);
    EXPECT_EQ(detail.kind, Detail::Kind::Filled);
    EXPECT_EQ(detail.filling, filledBy(0.008).filling);
    EXPECT_EQ(solid.mesh, hollow.mesh);
    EXPECT_EQ(solid.network->vertexNodes.size(), hollow.mesh->vertices.size());
    EXPECT_EQ(simulatedSurface(*solid.mesh, *solid.network), solid.network->lattice->surface);
    double mass = 0;
    for (const double node : evaluateModel(solid).mass)
        mass += node;
    EXPECT_NEAR(mass, 0.1, 1e-12);
}

TEST(FilledOrgan, IsHollowAgainAsItWas) {
    const Project hollow = hollowBall(), again = withDetail(withDetail(hollow, filledBy(0.008)), {});
    EXPECT_FALSE(again.network->lattice);
    EXPECT_FALSE(again.network->binding);
    EXPECT_EQ(again.network->restPositions, hollow.network->restPositions);
}

TEST(FilledOrgan, IsFixedWhereItsSurfaceWasAndNotWithin) {
    Project hollow = hollowBall();
    std::vector<std::uint32_t> half;
    for (std::uint32_t node = 0; node < hollow.network->restPositions.size(); ++node)
        if (hollow.network->restPositions[node].z() < 0) half.push_back(node);
    hollow.scene.fixed = {{half, std::nullopt}};
    const Project solid = withDetail(hollow, filledBy(0.006));
    const std::vector<std::uint32_t> atSurface = surfaceNodes(*solid.network->lattice);
    const std::set<std::uint32_t> fixed(solid.scene.fixed[0].nodes.begin(), solid.scene.fixed[0].nodes.end()),
        surface(atSurface.begin(), atSurface.end());
    for (const std::uint32_t node : fixed)
        EXPECT_EQ(surface.count(node), 1U) << node;
    for (const std::uint32_t node : atSurface)
        EXPECT_TRUE(solid.network->restPositions[node].z() > -0.005 || fixed.count(node) == 1) << node;
}

TEST(FilledOrgan, IsFixedNowhereByWhatWasFixedWithinOnceItIsHollow) {
    Project solid = withDetail(hollowBall(), filledBy(0.006));
    const std::vector<std::uint32_t> atSurface = surfaceNodes(*solid.network->lattice);
    const std::set<std::uint32_t> surface(atSurface.begin(), atSurface.end());
    std::vector<std::uint32_t> within;
    for (std::uint32_t node = 0; node < solid.network->restPositions.size(); ++node)
        if (surface.count(node) == 0) within.push_back(node);
    ASSERT_FALSE(within.empty());
    solid.scene.fixed = {{within, std::nullopt}};
    EXPECT_THAT(withDetail(solid, {}).scene.fixed[0].nodes, IsEmpty());
}

/// Nodes at the surface stand for less of the organ than others do.
TEST(FilledOrgan, GivesASmallRegionItsWholeMass) {
    Project solid = withDetail(hollowBall(), filledBy(0.006));
    Region region;
    region.ellipsoid = Ellipsoid{{0.1, 0, radius}, {0.008, 0.008, 0.002}, Eigen::Quaterniond::Identity()};
    region.held.mass = 0.02;
    solid.regions = {region};
    const std::vector<double> weights = nodeWeights(*solid.network, region);
    const std::vector<double> mass = evaluateModel(solid).mass;
    double reached = 0, sum = 0;
    for (std::size_t node = 0; node < mass.size(); ++node) {
        reached += weights[node];
        sum += weights[node] * mass[node];
    }
    ASSERT_GE(reached, 2);
    EXPECT_NEAR(sum, 0.02, 1e-12);
}

TEST(FilledOrgan, ForgetsWhatWasMeasuredOfAnotherFilling) {
    Project hollow = hollowBall();
    hollow.accuracy = std::make_shared<const MeasuredAccuracy>();
    EXPECT_FALSE(withDetail(hollow, filledBy(0.008)).accuracy);
    EXPECT_TRUE(withDetail(hollow, {Detail::Kind::Nodes, 300}).accuracy);
}

TEST(FilledOrgan, GivesWayToAnInstrumentAtItsSurface) {
    const Project solid = withDetail(hollowBall(), filledBy(0.008));
    Simulation simulation(evaluateModel(solid), {}, touchedSurface(*solid.mesh, *solid.network));
    Loads loads;
    for (int i = 0; i <= 30; ++i) {
        const Eigen::Vector3d place(0.1, 0, radius + 0.012 - 0.0003 * i);
        loads.instruments = {sphereAt(place, 0.01)};
        ASSERT_TRUE(simulation.step(loads)) << simulation.failure();
        for (const std::uint32_t node : surfaceNodes(*solid.network->lattice))
            ASSERT_GT((simulation.positions()[node] - place).norm(), 0.0099) << node;
    }
    EXPECT_TRUE(wasTouched(simulation));
}

TEST(FilledOrgan, IsRefusedWhereTheSurfaceIsOpen) {
    TriangleMesh open = test::ball(radius, {0, 0, 0});
    open.triangles.pop_back();
    const Project project = makeProject("open", {open, {}}, 0.1, {});
    try {
        withDetail(project, filledBy(0.008));
        FAIL() << "was filled";
    } catch (const InvalidModel& error) {
        EXPECT_THAT(error.what(), HasSubstr("open"));
    }
}

TEST(FilledOrgan, TellsItsProgress) {
    const Project hollow = hollowBall();
    test::expectGoodProgress(
        [&](const Progress& progress) { withDetail(hollow, filledBy(0.004), progress); });
}

} // namespace
} // namespace esm
