#include "core/dynamics/simulation.h"
#include "tests/support/analytic_oscillator.h"
#include "tests/support/every_integrator.h"
#include "tests/support/motion_difference.h"
#include "tests/support/sanitized.h"
#include "tests/support/simulation_settings.h"
#include "tests/support/tissue_models.h"

#include <gmock/gmock.h>

using namespace esm;
using tissue::Vectors;

namespace {

class EveryIntegrator : public testing::TestWithParam<Integrator> {};
INSTANTIATE_TEST_SUITE_P(Dynamics, EveryIntegrator, testing::ValuesIn(allIntegrators), nameOfIntegratorTest);

std::vector<double> stretchedSpringConstants() {
    if (isSanitized()) return {1};
    return {1, 100};
}

/// s; of hanging tissue that becomes stiffer, long enough to see it rise.
double risingTime() {
    return isSanitized() ? 0.05 : 1;
}

TEST_P(EveryIntegrator, AgreesWithATether) {
    TissueModel model = tissue::oneSpring({0, 0, 1});
    model.tethers = {{1, 20, 3}};
    Simulation simulation(model, withStep(GetParam(), 1.0 / 1000));
    Loads loads;
    loads.forces = {{1, {0, 1, 0}}};
    for (int i = 0; i < 1000; ++i)
        ASSERT_TRUE(simulation.step(loads));
    EXPECT_NEAR(simulation.positions()[1].y(), analyticOscillator(1, 20, 3, 1, 1), 2e-4);
    EXPECT_EQ(simulation.positions()[0], Eigen::Vector3d(0, 0, 0));
    for (int i = 0; i < 30000; ++i)
        ASSERT_TRUE(simulation.step({}));
    EXPECT_NEAR((simulation.positions()[1] - Eigen::Vector3d(1, 0, 0)).norm(), 0, 1e-9);
}

TEST_P(EveryIntegrator, KeepsMomentum) {
    const TissueModel model = tissue::fromMesh(tissue::sphereMesh(2, 0.05), {10, 0.05, 0.001});
    Simulation simulation(model, withStep(GetParam(), 1e-3));
    Loads kick;
    kick.forces = {{5, {0.3, -0.2, 0.1}}, {17, {-0.1, 0.4, 0.3}}};
    const Eigen::Vector3d given = Eigen::Vector3d(0.2, 0.2, 0.4) * 1e-3 * 10;
    for (int i = 0; i < 10; ++i)
        ASSERT_TRUE(simulation.step(kick));
    const auto momentum = [&] {
        Eigen::Vector3d sum = Eigen::Vector3d::Zero();
        for (const auto& velocity : simulation.velocities())
            sum += 0.001 * velocity;
        return sum;
    };
    // Forces settle to a part of them only.
    const double tolerance = GetParam() == Integrator::Propagation ? 1e-6 : 1e-10;
    EXPECT_LT((momentum() - given).norm(), tolerance * given.norm());
    for (int i = 0; i < 400; ++i)
        ASSERT_TRUE(simulation.step({}));
    EXPECT_LT((momentum() - given).norm(), tolerance * given.norm());
}

TEST_P(EveryIntegrator, LeavesWhatRestsAtRest) {
    const TissueModel model = tissue::fromMesh(tissue::sphereMesh(2, 0.05), {});
    Simulation simulation(model, withStep(GetParam(), 1e-3));
    for (int i = 0; i < 50; ++i)
        ASSERT_TRUE(simulation.step({}));
    EXPECT_EQ(simulation.positions(), model.network->restPositions);
    EXPECT_EQ(simulation.energy().kinetic + simulation.energy().elastic, 0);
}

TEST_P(EveryIntegrator, KeepsAMirrorSymmetry) {
    const TissueModel model = tissue::fromMesh(tissue::sphereMesh(2, 0.05), {});
    Simulation simulation(model, withStep(GetParam(), 1e-3));
    Loads loads;
    const auto& rest = model.network->restPositions;
    for (std::uint32_t i = 0; i < rest.size(); ++i)
        loads.forces.emplace_back(i, Eigen::Vector3d(rest[i].x() * rest[i].z(), 0.01 * rest[i].y(), 0.001));
    for (int i = 0; i < 200; ++i)
        ASSERT_TRUE(simulation.step(loads));
    std::size_t pairs = 0;
    for (std::size_t i = 0; i < rest.size(); ++i) {
        const Eigen::Vector3d mirrored(-rest[i].x(), rest[i].y(), rest[i].z());
        for (std::size_t j = 0; j < rest.size(); ++j) {
            if ((rest[j] - mirrored).norm() > 1e-9) continue;
            const Eigen::Vector3d a = simulation.positions()[i], b = simulation.positions()[j];
            EXPECT_LT((Eigen::Vector3d(-a.x(), a.y(), a.z()) - b).norm(), 1e-11);
            ++pairs;
        }
    }
    EXPECT_EQ(pairs, rest.size());
}

TEST_P(EveryIntegrator, DoesNotDependOnTheOrderOfNodes) {
    const TriangleMesh mesh = tissue::gridMesh(9, 0.1);
    const auto count = static_cast<std::uint32_t>(mesh.vertices.size());
    const auto renumbered = [count](std::uint32_t node) { return (node * 37 + 11) % count; };
    TriangleMesh shuffled = mesh;
    for (std::uint32_t i = 0; i < count; ++i)
        shuffled.vertices[renumbered(i)] = mesh.vertices[i];
    for (Triangle& triangle : shuffled.triangles)
        for (std::uint32_t& node : triangle)
            node = renumbered(node);

    TissueModel model = tissue::fromMesh(mesh, {}), other = tissue::fromMesh(shuffled, {});
    model.fixedNodes = {0};
    other.fixedNodes = {renumbered(0)};
    Simulation first(model, withStep(GetParam(), 1e-3)), second(other, withStep(GetParam(), 1e-3));
    Loads loads, otherLoads;
    loads.gravity = otherLoads.gravity = {0, 0, -9.81};
    loads.forces = {{40, {0.01, 0.02, 0.1}}};
    otherLoads.forces = {{renumbered(40), {0.01, 0.02, 0.1}}};
    for (int i = 0; i < 200; ++i)
        ASSERT_TRUE(first.step(loads) && second.step(otherLoads));
    for (std::uint32_t i = 0; i < count; ++i)
        EXPECT_LT((first.positions()[i] - second.positions()[renumbered(i)]).norm(), 1e-11);
}

TEST_P(EveryIntegrator, NeverMovesFixedNodes) {
    TissueModel model = tissue::fromMesh(tissue::gridMesh(7, 0.1), {});
    model.fixedNodes = {0, 6, 24, 48};
    Simulation simulation(model, withStep(GetParam(), 1e-3));
    Loads loads;
    loads.gravity = {0, 0, -9.81};
    loads.prescribed = {{6, {1, 1, 1}}};
    for (int i = 0; i < 100; ++i)
        ASSERT_TRUE(simulation.step(loads));
    for (const std::uint32_t node : model.fixedNodes)
        EXPECT_EQ(simulation.positions()[node], model.network->restPositions[node]);
    EXPECT_LT(simulation.positions()[25].z(), 0);
}

TEST_P(EveryIntegrator, LedNodesReachTheirPlaceAndDragTheOthers) {
    TissueModel model = tissue::fromMesh(tissue::gridMesh(15, 0.1), {10, 5, 0.001});
    for (std::uint32_t i = 0; i < 15; ++i)
        model.fixedNodes.push_back(i);
    const double step = isExplicit(GetParam()) ? 1e-5 : GetParam() == Integrator::Propagation ? 2e-5 : 1e-3;
    for (const std::size_t ledCount : {std::size_t{1}, std::size_t{3}, std::size_t{70}}) {
        Simulation simulation(model, withStep(GetParam(), step));
        Loads loads;
        for (std::uint32_t i = 0; i < ledCount; ++i)
            loads.prescribed.push_back(
                {224 - i, model.network->restPositions[224 - i] + Eigen::Vector3d(0, 0, 0.002)});
        ASSERT_TRUE(simulation.step(loads));
        for (const PrescribedNode& led : loads.prescribed)
            EXPECT_EQ(simulation.positions()[led.node], led.position);
        if (step == 1e-3) {
            EXPECT_GT(simulation.positions()[224 - ledCount].z(), 0.0002) << ledCount;
        }
        for (int i = 0; i < 3000 && simulation.positions()[112].z() <= 1e-5; ++i)
            ASSERT_TRUE(simulation.step(loads));
        EXPECT_EQ(simulation.positions()[224], loads.prescribed[0].position);
        EXPECT_GT(simulation.positions()[112].z(), 1e-5);
    }
}

// The same nodes led by impulses (few) and as prescribed ones (many) must move the rest alike.
TEST_P(EveryIntegrator, LeadsFewAndManyNodesAlike) {
    const TissueModel model = tissue::fromMesh(tissue::gridMesh(15, 0.1), {10, 0.01, 0.001});
    Loads few, many;
    for (std::uint32_t i = 0; i < 70; ++i) {
        const PrescribedNode led{i,
                                 model.network->restPositions[i] + Eigen::Vector3d(0, 0, i < 30 ? 0.001 : 0)};
        many.prescribed.push_back(led);
        if (i < 60) few.prescribed.push_back(led);
    }
    TissueModel fixedToo = model;
    for (std::uint32_t i = 60; i < 70; ++i)
        fixedToo.fixedNodes.push_back(i);
    Simulation first(fixedToo, withStep(GetParam(), 1e-3)), second(model, withStep(GetParam(), 1e-3));
    for (int i = 0; i < 20; ++i)
        ASSERT_TRUE(first.step(few) && second.step(many));
    for (std::size_t i = 0; i < first.positions().size(); ++i)
        EXPECT_LT((first.positions()[i] - second.positions()[i]).norm(), 1e-12);
}

TEST_P(EveryIntegrator, SpringsOfNoLengthGiveNoForceAndNoNan) {
    SpringNetwork network;
    network.restPositions = {{0, 0, 0}, {0, 0, 0}, {0.01, 0, 0}};
    network.springs = {{0, 1, 0.0}, {0, 2, 0.01}, {1, 2, 0.01}};
    const TissueModel model = tissue::model(network, {});
    Simulation simulation(model, withStep(GetParam(), 1e-3));
    for (int i = 0; i < 10; ++i)
        ASSERT_TRUE(simulation.step({}));
    EXPECT_EQ(simulation.positions(), model.network->restPositions);
    Loads loads;
    loads.forces = {{0, {0, 0.01, 0}}};
    for (int i = 0; i < 100; ++i)
        ASSERT_TRUE(simulation.step(loads));
    EXPECT_GT(simulation.positions()[0].y(), 0);
    EXPECT_TRUE(simulation.positions()[1].allFinite());
}

TEST_P(EveryIntegrator, ReportsDivergenceAndKeepsTheLastGoodState) {
    if (!isExplicit(GetParam()) && GetParam() != Integrator::Split && GetParam() != Integrator::Split2)
        GTEST_SKIP() << "stable at any step";
    const TissueModel model = tissue::fromMesh(tissue::gridMesh(9, 0.1), {1e6, 0.001, 1e-4});
    Simulation simulation(model, withStep(GetParam(), 0.01));
    Loads loads;
    loads.forces = {{40, {0, 0, 1}}};
    Vectors before;
    bool good = true;
    for (int i = 0; i < 1000 && good; ++i) {
        before = simulation.positions();
        good = simulation.step(loads);
    }
    ASSERT_FALSE(good);
    EXPECT_FALSE(simulation.failure().empty());
    EXPECT_EQ(simulation.positions(), before);
    // The tissue is stiff: no part of it can have gone far.
    EXPECT_LT(boundingBox(simulation.positions()).diagonal().norm(),
              3 * boundingBox(model.network->restPositions).diagonal().norm());
}

TEST_P(EveryIntegrator, LetsForcesStretchTissueTenfold) {
    for (const double stiffness : stretchedSpringConstants()) {
        TissueModel model = tissue::fromMesh(tissue::gridMesh(9, 0.1), {stiffness, 0.02, 0.001});
        for (std::uint32_t i = 0; i < 9; ++i)
            model.fixedNodes.push_back(i);
        SimulationSettings settings;
        settings.integrator = GetParam();
        Simulation simulation(model, settings);
        Loads loads;
        for (std::uint32_t i = 72; i < 81; ++i)
            loads.forces.emplace_back(i, Eigen::Vector3d(0, 0.2 * stiffness, 0));
        while (simulation.time() < 2)
            ASSERT_TRUE(simulation.step(loads)) << simulation.failure();
        EXPECT_GT(simulation.positions()[76].y() - simulation.positions()[4].y(), 1);
        loads.forces.clear();
        while (simulation.time() < 4)
            ASSERT_TRUE(simulation.step(loads)) << simulation.failure();
    }
}

TEST_P(EveryIntegrator, LetsLedNodesStretchTissueTenfold) {
    const TissueModel model = tissue::fromMesh(tissue::gridMesh(9, 0.1), {10, 0.02, 0.001});
    SimulationSettings settings;
    settings.integrator = GetParam();
    Simulation simulation(model, settings);
    const auto& rest = model.network->restPositions;
    Loads loads;
    for (std::uint32_t i = 0; i < 9; ++i)
        loads.prescribed.push_back({i, rest[i]});
    for (std::uint32_t i = 72; i < 81; ++i)
        loads.prescribed.push_back({i, rest[i] + Eigen::Vector3d(0, 1, 0)});
    while (simulation.time() < 1)
        ASSERT_TRUE(simulation.step(loads)) << simulation.failure();
    loads.prescribed.clear();
    while (simulation.time() < 2)
        ASSERT_TRUE(simulation.step(loads)) << simulation.failure();
}

TEST_P(EveryIntegrator, TakesNewParametersWhileMoving) {
    TissueModel model = tissue::fromMesh(tissue::gridMesh(9, 0.1), {10, 0.01, 0.001});
    model.fixedNodes = {0, 8, 72, 80};
    SimulationSettings settings;
    settings.integrator = GetParam();
    Simulation simulation(model, settings);
    Loads loads;
    loads.gravity = {0, 0, -9.81};
    for (int i = 0; i < 20; ++i)
        ASSERT_TRUE(simulation.step(loads));
    const Vectors positions = simulation.positions(), velocities = simulation.velocities();
    const double time = simulation.time();
    TissueModel stiffer = model;
    for (double& c : stiffer.springConstant)
        c *= 100;
    simulation.setModel(stiffer);
    EXPECT_EQ(simulation.positions(), positions);
    EXPECT_EQ(simulation.velocities(), velocities);
    EXPECT_DOUBLE_EQ(simulation.time(), time);
    const double low = simulation.positions()[40].z();
    double highest = low;
    while (simulation.time() < time + risingTime()) {
        ASSERT_TRUE(simulation.step(loads)) << simulation.failure();
        highest = std::max(highest, simulation.positions()[40].z());
    }
    EXPECT_GT(highest, low + 1e-4);
}

TEST(Damping, AxialLeavesARotationAlone) {
    TissueModel model = tissue::oneSpring({1000, 5, 1});
    SimulationSettings settings = withStep(Integrator::Euler, 1e-4);
    settings.damping = Damping::Axial;
    Simulation axial(model, settings);
    Simulation isotropic(model, withStep(Integrator::Euler, 1e-4));
    Loads spin;
    spin.forces = {{0, {0, -1, 0}}, {1, {0, 1, 0}}};
    for (int i = 0; i < 2000; ++i) {
        ASSERT_TRUE(axial.step(i < 100 ? spin : Loads{}));
        ASSERT_TRUE(isotropic.step(i < 100 ? spin : Loads{}));
    }
    EXPECT_NEAR(axial.velocities()[1].norm(), 0.01, 1e-5);
    EXPECT_LT(isotropic.velocities()[1].norm(), 0.002);
}

// Errors of the published prototype: 1.3e-3 at 0.05 s and 5.5e-5 at 0.01 s for split2, 8e-4 for split at
// 0.005 s.
TEST(FallopianTube, SplitStepsFollowTinySteps) {
    const TissueModel tube = tissue::fallopianTube();
    const auto after = [&](Integrator integrator, double step) {
        Simulation simulation(tube, withStep(integrator, step));
        Loads pull;
        pull.forces = {{85, {0, 0, 0.1}}};
        for (int i = 0; i < static_cast<int>(std::lround(1 / step)); ++i)
            EXPECT_TRUE(simulation.step(pull));
        return simulation;
    };
    const Simulation reference = after(Integrator::Split2, 2e-4);
    const auto errorOf = [&](Integrator integrator, double step) {
        return motionDifference(after(integrator, step).positions(), reference.positions(),
                                tube.network->restPositions);
    };
    EXPECT_LT(errorOf(Integrator::Split2, 0.05), 3e-3);
    EXPECT_LT(errorOf(Integrator::Split2, 0.01), 1.2e-4);
    EXPECT_LT(errorOf(Integrator::Split, 0.005), 1.6e-3);
}

} // namespace
