#include "core/dynamics/statics/pressed_tissue.h"

#include "core/dynamics/forces.h"
#include "core/dynamics/simulation.h"
#include "tests/support/flat_nets.h"
#include "tests/support/sanitized.h"
#include "tests/support/tethered_triangle.h"
#include "tests/support/tissue_models.h"

#include <gtest/gtest.h>

namespace esm {
namespace {

using Eigen::Vector3d;

Indenter fingerAbove(const Vector3d& place, double radius) {
    return {radius, place + radius * Vector3d::UnitZ(), -Vector3d::UnitZ()};
}

/// Of a force, as it is promised.
constexpr double accuracy = 1e-3;

TEST(PressedTissue, TakesTheForceOfItsTethers) {
    const TissueModel model = test::tetheredTriangle();
    const SpringSystem system = makeSpringSystem(model);
    PressedTissue tissue(system, test::largeTriangle().triangles, fingerAbove(Vector3d::Zero(), 0.01));
    for (const double depth : {0.001, 0.004, 0.002}) {
        tissue.settle(AtDepth{depth});
        EXPECT_NEAR(tissue.force(), 3 * test::tetherConstant * depth, accuracy * tissue.force());
    }
    tissue.settle(UnderForce{0.3});
    EXPECT_NEAR(tissue.force(), 0.3, accuracy * 0.3);
    EXPECT_NEAR(tissue.depth(), 0.3 / (3 * test::tetherConstant), 1e-6);
}

TEST(PressedTissue, LeavesAFingerThatOnlyTouchesAlone) {
    const TissueModel model = test::tetheredTriangle();
    const SpringSystem system = makeSpringSystem(model);
    PressedTissue tissue(system, test::largeTriangle().triangles, fingerAbove(Vector3d::Zero(), 0.01));
    tissue.settle(AtDepth{0});
    EXPECT_NEAR(tissue.force(), 0, 1e-9);
    EXPECT_EQ(tissue.positions(), model.network->restPositions);
}

/// A ball whose lower nodes are fixed.
TissueModel seatedBall(const TriangleMesh& mesh) {
    TissueModel model = tissue::fromMesh(mesh, {20, 1, 1e-3});
    for (std::uint32_t node = 0; node < mesh.vertices.size(); ++node) {
        model.tethers.push_back({node, 4, 0.2});
        if (mesh.vertices[node].z() < -0.03) model.fixedNodes.push_back(node);
    }
    return model;
}

/// N, from impulses in a run of the program's own simulation that has come to rest: another way to the same
/// place.
double simulatedForce(const TissueModel& model, const TriangleMesh& mesh, const Indenter& finger,
                      double depth) {
    Simulation simulation(model, {}, TouchedSurface(mesh.triangles));
    Loads loads;
    loads.instruments = {sphereAt(finger.start, finger.radius)};
    simulation.placeInstruments({loads.instruments[0].pose});
    Vector3d before = Vector3d::Zero();
    double begin = 0;
    for (const double end : {1.0, 6.0, 7.0}) {
        before = simulation.instrumentTouches().empty() ? before : simulation.instrumentTouches()[0].impulse;
        begin = simulation.time();
        while (simulation.time() < end) {
            const double part = std::min(1.0, simulation.time() + simulation.timeStep());
            loads.instruments = {sphereAt(finger.start + part * depth * finger.inwards, finger.radius)};
            EXPECT_TRUE(simulation.step(loads)) << simulation.failure();
        }
    }
    return (simulation.instrumentTouches()[0].impulse - before).z() / (simulation.time() - begin);
}

TEST(PressedTissue, HasTheForceThatASimulationComesTo) {
    const TriangleMesh mesh = tissue::sphereMesh(3, 0.05);
    const TissueModel model = seatedBall(mesh);
    const SpringSystem system = makeSpringSystem(model);
    constexpr double depth = 0.004;
    const Indenter finger = fingerAbove({0, 0, 0.05}, 0.02);
    PressedTissue tissue(system, mesh.triangles, finger);
    tissue.settle(AtDepth{depth});
    const double force = simulatedForce(model, mesh, finger, depth);
    EXPECT_NEAR(tissue.force(), force, 0.01 * force);
}

/// The same ball with a fluid in it, Pa.
TissueModel filledBall(const TriangleMesh& mesh, double stiffness) {
    TissueModel model = seatedBall(mesh);
    model.cavities = {cavityOf(mesh.vertices, mesh.triangles, 0)};
    model.cavities.front().stiffness = stiffness;
    return model;
}

TEST(PressedTissue, HasTheForceThatASimulationOfAFluidComesTo) {
    const TriangleMesh mesh = tissue::sphereMesh(3, 0.05);
    const TissueModel model = filledBall(mesh, 1e5), dry = seatedBall(mesh);
    constexpr double depth = 0.003;
    const Indenter finger = fingerAbove({0, 0, 0.05}, 0.02);
    const double force = simulatedForce(model, mesh, finger, depth);
    const auto balancedForce = [&](const TissueModel& ball) {
        const SpringSystem system = makeSpringSystem(ball);
        PressedTissue tissue(system, mesh.triangles, finger);
        tissue.settle(AtDepth{depth});
        return tissue.force();
    };
    EXPECT_NEAR(balancedForce(model), force, 0.01 * force);
    EXPECT_LT(balancedForce(dry), 0.98 * force) << "the fluid resists";
}

TEST(PressedTissue, KeepsTheVolumeOfAStiffFluid) {
    const TriangleMesh mesh = tissue::sphereMesh(3, 0.05);
    const TissueModel model = filledBall(mesh, 1e6);
    const SpringSystem system = makeSpringSystem(model);
    PressedTissue tissue(system, mesh.triangles, fingerAbove({0, 0, 0.05}, 0.02));
    for (const double depth : {0.005, 0.015}) {
        tissue.settle(AtDepth{depth});
        const SpringSystem::Filled& fluid = system.cavities.front();
        EXPECT_NEAR(volumesOf(system, tissue.positions()).front(), fluid.restVolume, 1e-3 * fluid.restVolume);
        EXPECT_GT(ownPressure(fluid, volumesOf(system, tissue.positions()).front()), 0);
    }
}

// What a finger does on a small way is what all of the tissue stores.
TEST(PressedTissue, StoresTheWorkOfTheFinger) {
    const TriangleMesh mesh = tissue::sphereMesh(3, 0.05);
    const TissueModel model = filledBall(mesh, 1e5);
    const SpringSystem system = makeSpringSystem(model);
    PressedTissue tissue(system, mesh.triangles, fingerAbove({0, 0, 0.05}, 0.02));
    constexpr double depth = 0.01, way = 1e-4;
    std::vector<double> energies, forces;
    for (const double at : {depth - way, depth, depth + way}) {
        tissue.settle(AtDepth{at});
        energies.push_back(energy(system, tissue.positions(), {}).elastic);
        forces.push_back(tissue.force());
    }
    EXPECT_NEAR((energies[2] - energies[0]) / (2 * way), forces[1], 0.003 * forces[1]);
}

TEST(PressedTissue, ComesToAGivenForceAgainstAFluid) {
    const TriangleMesh mesh = tissue::sphereMesh(3, 0.05);
    const TissueModel model = filledBall(mesh, 1e5);
    const SpringSystem system = makeSpringSystem(model);
    PressedTissue byDepth(system, mesh.triangles, fingerAbove({0, 0, 0.05}, 0.02)), byForce = byDepth;
    byDepth.settle(AtDepth{0.006});
    byForce.settle(UnderForce{byDepth.force()});
    EXPECT_NEAR(byForce.depth(), 0.006, accuracy * 0.006);
}

TEST(PressedTissue, FeelsTheSameInOneStepAndInMany) {
    const TriangleMesh mesh = tissue::sphereMesh(3, 0.05);
    const TissueModel model = seatedBall(mesh);
    const SpringSystem system = makeSpringSystem(model);
    PressedTissue once(system, mesh.triangles, fingerAbove({0, 0, 0.05}, 0.02)), often = once;
    once.settle(AtDepth{0.004});
    for (int i = 1; i <= 8; ++i)
        often.settle(AtDepth{0.0005 * i});
    EXPECT_NEAR(once.force(), often.force(), 0.002 * once.force());
}

/// A flat net that bends freely, of triangles with sides of 5 mm, its border fixed.
TissueModel flatNet(TriangleMesh& mesh) {
    mesh = test::regularNet(12, 14);
    const Vector3d middle = mesh.vertices[7 * 13 + 6];
    for (Vector3d& vertex : mesh.vertices)
        vertex = 0.005 * (vertex - middle);
    TissueModel model = tissue::fromMesh(mesh, {10, 1, 1e-3});
    const std::vector<bool> border = test::isAtBorder(mesh);
    for (std::uint32_t node = 0; node < border.size(); ++node)
        if (border[node]) model.fixedNodes.push_back(node);
    return model;
}

// Nothing of it resists a push across until it is stretched: its force grows from nothing with the third
// power of the depth, while the finger touches a node alone. What the finger pushes with is what the border
// bears.
TEST(PressedTissue, PressesASheetThatResistsNothingAcross) {
    TriangleMesh mesh;
    const TissueModel model = flatNet(mesh);
    const SpringSystem system = makeSpringSystem(model);
    const auto forceAt = [&](double depth) {
        PressedTissue tissue(system, mesh.triangles, fingerAbove(Vector3d::Zero(), 0.008));
        tissue.settle(AtDepth{depth});
        Vectors forces;
        elasticForces(system, tissue.positions(), forces);
        double borne = 0;
        for (const std::uint32_t node : model.fixedNodes)
            borne -= forces[node].z();
        EXPECT_NEAR(tissue.force(), borne, 0.01 * borne) << depth;
        return tissue.force();
    };
    for (const double depth : {5e-5, 1e-4, 2e-4})
        EXPECT_NEAR(forceAt(2 * depth) / forceAt(depth), std::pow(2, 3), 0.05 * 8) << depth;
}

TEST(PressedTissue, PressesASheetThatResistsNothingAcrossInManySmallSteps) {
    if (isSanitized()) GTEST_SKIP() << "one step shows the sanitizers the same";
    TriangleMesh mesh;
    const TissueModel model = flatNet(mesh);
    const SpringSystem system = makeSpringSystem(model);
    PressedTissue often(system, mesh.triangles, fingerAbove(Vector3d::Zero(), 0.008)), once = often;
    for (int i = 1; i <= 40; ++i)
        often.settle(AtDepth{5e-5 * i});
    once.settle(AtDepth{0.002});
    EXPECT_NEAR(often.force(), once.force(), 2 * accuracy * once.force());
}

// Against dampers alone: a step after step creep to the depth at rest with the time d/c.
TEST(PressedTissue, CreepsAsItsTethersLetIt) {
    const TissueModel model = test::tetheredTriangle();
    const SpringSystem system = makeSpringSystem(model);
    PressedTissue tissue(system, test::largeTriangle().triangles, fingerAbove(Vector3d::Zero(), 0.01));
    const double time = test::tetherViscosity / test::tetherConstant;
    constexpr int steps = 200;
    for (int i = 0; i < steps; ++i)
        tissue.step(UnderForce{0.3}, time / steps);
    const double end = 0.3 / (3 * test::tetherConstant);
    EXPECT_NEAR(tissue.depth(), end * (1 - std::exp(-1.0)), 0.01 * end);
}

} // namespace
} // namespace esm
