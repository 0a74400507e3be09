#include "core/dynamics/contact/contact.h"
#include "core/dynamics/simulation.h"
#include "tests/support/sanitized.h"
#include "tests/support/simulation_settings.h"
#include "tests/support/tissue_models.h"
#include "tests/support/was_touched.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace esm;
using Eigen::Vector3d;
using tissue::Vectors;

namespace {

/// How far the surface reaches into a collider, in radii: the deepest of many points of every triangle.
double penetration(const std::vector<Triangle>& surface, const Vectors& positions,
                   const PlacedCollider& collider) {
    constexpr int samples = 12;
    const ColliderAxis axis = axisOf(collider);
    const double radius = radiusOf(collider.shape);
    double nearest = std::numeric_limits<double>::infinity();
    for (const auto& [a, b, c] : surface) {
        const double size = (positions[b] - positions[a]).norm() + (positions[c] - positions[a]).norm();
        if ((positions[a] - axis.at(axis.nearest(positions[a]))).norm() > radius + size) continue;
        for (int i = 0; i <= samples; ++i)
            for (int j = 0; i + j <= samples; ++j) {
                const Vector3d point =
                    (i * positions[a] + j * positions[b] + (samples - i - j) * positions[c]) / samples;
                nearest = std::min(nearest, (point - axis.at(axis.nearest(point))).norm());
            }
    }
    return std::max(0.0, 1 - nearest / radius);
}

struct Poke {
    Vector3d start, direction;
    double depth, speed, radius; ///< m, m/s, m
};

struct Tissue {
    TissueModel model;
    std::vector<Triangle> surface;
    SimulationSettings settings{};
};

/// Pushes a sphere in and back out, then waits. Every step must leave nothing inside it.
Simulation poke(const Tissue& tissue, const Poke& way, double wait) {
    Simulation simulation(tissue.model, tissue.settings, tissue.surface);
    const double there = way.depth / way.speed;
    double deepest = 0, fastest = 0;
    Loads away;
    away.instruments = {sphereAt(way.start, way.radius)};
    EXPECT_TRUE(simulation.step(away));
    const double begin = simulation.time();
    while (simulation.time() < begin + 2 * there) {
        const double time = simulation.time() - begin + simulation.timeStep();
        const double in = way.speed * (time < there ? time : std::max(0.0, 2 * there - time));
        Loads loads;
        loads.instruments = {sphereAt(way.start + in * way.direction, way.radius)};
        EXPECT_TRUE(simulation.step(loads)) << simulation.failure();
        if (!simulation.failure().empty()) return simulation;
        deepest =
            std::max(deepest, penetration(tissue.surface, simulation.positions(), loads.instruments.front()));
        for (const Vector3d& velocity : simulation.velocities())
            fastest = std::max(fastest, velocity.norm());
    }
    EXPECT_LT(deepest, 1e-6);
    EXPECT_LT(fastest, 20 * way.speed) << "the tissue was thrown";
    for (const double end = simulation.time() + wait; simulation.time() < end;)
        EXPECT_TRUE(simulation.step(away)) << simulation.failure();
    return simulation;
}

Tissue membrane(int perSide, const tissue::Parameters& parameters, Integrator integrator) {
    const TriangleMesh mesh = tissue::gridMesh(perSide, 0.1);
    Tissue result{tissue::fromMesh(mesh, parameters), mesh.triangles};
    for (std::uint32_t i = 0; i < mesh.vertices.size(); ++i)
        if (std::abs(mesh.vertices[i].x()) > 0.0499 || std::abs(mesh.vertices[i].y()) > 0.0499)
            result.model.fixedNodes.push_back(i);
    // A flat net of unstretched springs does not resist going out of its plane.
    for (std::uint32_t i = 0; i < mesh.vertices.size(); ++i)
        result.model.tethers.push_back({i, 1, 0.02});
    result.settings.integrator = integrator;
    return result;
}

/// Of the node farthest from its rest position, m.
double displacement(const Simulation& simulation, const Tissue& tissue) {
    double largest = 0;
    for (std::size_t i = 0; i < simulation.positions().size(); ++i)
        largest =
            std::max(largest, (simulation.positions()[i] - tissue.model.network->restPositions[i]).norm());
    return largest;
}

constexpr tissue::Parameters soft{20, 0.4, 1e-4};
const std::vector<Integrator> fewerIntegrators{Integrator::Euler, Integrator::Split, Integrator::Split2};

std::vector<double> pokeSpeeds() {
    if (isSanitized()) return {0.3};
    return {0.06, 0.3, 3.0};
}

std::vector<Vector3d> pokeSides() {
    if (isSanitized()) return {{0.007, 0.002, 0}};
    return {{0, 0, 0}, {0.007, 0.002, 0}, {0.01, 0.01, 0}};
}

int membraneNodesPerSide() {
    return isSanitized() ? 9 : 21;
}

TEST(Contact, MembraneGivesWayAndSpringsBack) {
    for (const Integrator integrator : fewerIntegrators)
        for (const double speed : pokeSpeeds()) {
            if (integrator == Integrator::Euler && speed < 0.1) continue; // too many short steps for a test
            SCOPED_TRACE(std::string(integratorName(integrator)) + " at " + std::to_string(speed) + " m/s");
            const Tissue tissue = membrane(membraneNodesPerSide(), soft, integrator);
            const Simulation simulation =
                poke(tissue, {{0.003, 0.002, 0.02}, {0, 0, -1}, 0.03, speed, 0.01}, 1);
            EXPECT_LT(displacement(simulation, tissue), 0.003);
        }
}

TEST(Contact, EveryIntegratorMakesWayAndSpringsBack) {
    for (const Integrator integrator : allIntegrators) {
        if (isSanitized() && isExplicit(integrator)) continue; // too many short steps
        SCOPED_TRACE(integratorName(integrator));
        const Tissue tissue = membrane(9, {20, 0.02, 1e-4}, integrator);
        const Simulation simulation = poke(tissue, {{0.003, 0.002, 0.02}, {0, 0, -1}, 0.03, 1, 0.01}, 0.5);
        EXPECT_LT(displacement(simulation, tissue), 0.003);
    }
}

TEST(Contact, SmallSphereDoesNotSlipBetweenNodes) {
    for (const Integrator integrator : fewerIntegrators)
        for (const Vector3d& side : pokeSides()) {
            SCOPED_TRACE(std::string(integratorName(integrator)));
            const Tissue tissue = membrane(7, soft, integrator);
            Simulation simulation =
                poke(tissue, {side + Vector3d(0, 0, 0.01), {0, 0, -1}, 0.02, 0.1, 0.002}, 1);
            EXPECT_LT(displacement(simulation, tissue), 0.003);
        }
}

std::vector<double> dentingSpeeds() {
    if (isSanitized()) return {1};
    return {0.05, 1};
}

TEST(Contact, ClosedOrganIsDentedFromOutside) {
    const TriangleMesh mesh = tissue::sphereMesh(4, 0.05);
    for (const double speed : dentingSpeeds()) {
        Tissue organ{tissue::fromMesh(mesh, soft), mesh.triangles};
        for (std::uint32_t i = 0; i < mesh.vertices.size(); i += 3)
            organ.model.tethers.push_back({i, 5, 0.1});
        SCOPED_TRACE(speed);
        const Simulation simulation = poke(organ, {{0.08, 0, 0}, {-1, 0, 0}, 0.05, speed, 0.015}, 2);
        EXPECT_LT(displacement(simulation, organ), 0.003);
    }
}

TEST(Contact, ALeapOfThirtyRadiiTakesTheTissueAlong) {
    for (const Integrator integrator : allIntegrators) {
        SCOPED_TRACE(integratorName(integrator));
        const Tissue tissue = membrane(21, soft, integrator);
        Simulation simulation(tissue.model, tissue.settings, tissue.surface);
        Loads loads;
        loads.instruments = {sphereAt({0.003, 0.002, 0.02}, 0.002)};
        ASSERT_TRUE(simulation.step(loads));
        loads.instruments = {sphereAt({0.003, 0.002, -0.04}, 0.002)};
        ASSERT_TRUE(simulation.step(loads)) << simulation.failure();
        EXPECT_LT(penetration(tissue.surface, simulation.positions(), loads.instruments.front()), 1e-6);
        const auto lowest = std::min_element(simulation.positions().begin(), simulation.positions().end(),
                                             [](const auto& a, const auto& b) { return a.z() < b.z(); });
        EXPECT_LT(lowest->z(), -0.04);
    }
}

/// A sphere that stood above the middle of the membrane has leapt to below where it was.
void expectTakenAlong(Simulation& simulation, const Tissue& tissue) {
    Loads loads;
    loads.instruments = {sphereAt({0.003, 0.002, -0.04}, 0.01)};
    ASSERT_TRUE(simulation.step(loads)) << simulation.failure();
    EXPECT_LT(penetration(tissue.surface, simulation.positions(), loads.instruments.front()), 1e-6);
    const auto lowest = std::min_element(simulation.positions().begin(), simulation.positions().end(),
                                         [](const auto& a, const auto& b) { return a.z() < b.z(); });
    EXPECT_LT(lowest->z(), -0.04);
}

TEST(Contact, ALeapRightAfterNewParametersTakesTheTissueAlong) {
    for (const Integrator integrator : allIntegrators) {
        SCOPED_TRACE(integratorName(integrator));
        Tissue tissue = membrane(21, soft, integrator);
        Simulation simulation(tissue.model, tissue.settings, tissue.surface);
        Loads loads;
        loads.instruments = {sphereAt({0.003, 0.002, 0.02}, 0.01)};
        ASSERT_TRUE(simulation.step(loads));
        for (double& viscosity : tissue.model.viscosity)
            viscosity *= 1.5;
        simulation.setModel(tissue.model);
        expectTakenAlong(simulation, tissue);
    }
}

TEST(Contact, ALeapRightAfterAFailedStepTakesTheTissueAlong) {
    const Tissue tissue = membrane(21, soft, Integrator::Split);
    Simulation simulation(tissue.model, tissue.settings, tissue.surface);
    Loads loads;
    loads.instruments = {sphereAt({0.003, 0.002, 0.02}, 0.01)};
    ASSERT_TRUE(simulation.step(loads));
    loads.forces = {{220, {0, 0, 1e308}}};
    ASSERT_FALSE(simulation.step(loads));
    expectTakenAlong(simulation, tissue);
}

TEST(Contact, AnInstrumentThatWasPlacedSweepsFromThere) {
    const Tissue tissue = membrane(21, soft, Integrator::Split);
    Simulation simulation(tissue.model, tissue.settings, tissue.surface);
    simulation.placeInstruments({{{0.003, 0.002, 0.02}}});
    expectTakenAlong(simulation, tissue);
}

TEST(Contact, LedTissueIsNotDrawnThroughARestingSphere) {
    for (const Integrator integrator : allIntegrators) {
        SCOPED_TRACE(integratorName(integrator));
        Tissue tissue = membrane(21, soft, integrator);
        tissue.model.fixedNodes.clear();
        const auto& rest = tissue.model.network->restPositions;
        // All but a square in the middle, drawn up past the sphere at once.
        Loads loads;
        loads.instruments = {sphereAt({0.003, 0.002, 0.02}, 0.01)};
        for (std::uint32_t i = 0; i < rest.size(); ++i)
            if (std::max(std::abs(rest[i].x()), std::abs(rest[i].y())) > 0.008)
                loads.prescribed.push_back({i, rest[i]});
        Simulation simulation(tissue.model, tissue.settings, tissue.surface);
        ASSERT_TRUE(simulation.step(loads));
        for (PrescribedNode& led : loads.prescribed)
            led.position.z() += 0.05;
        for (int i = 0; i < 5; ++i) {
            ASSERT_TRUE(simulation.step(loads)) << simulation.failure();
            EXPECT_LT(simulation.positions()[220].z(), 0.0101) << i;
        }
    }
}

TEST(Contact, FixedTissueLetsTheSpherePass) {
    Tissue tissue = membrane(9, soft, Integrator::Auto);
    tissue.model.fixedNodes.clear();
    for (std::uint32_t i = 0; i < 81; ++i)
        tissue.model.fixedNodes.push_back(i);
    Simulation simulation(tissue.model, tissue.settings, tissue.surface);
    for (int i = 0; i < 100; ++i) {
        Loads loads;
        loads.instruments = {sphereAt({0, 0, 0.02 - 0.0004 * i}, 0.01)};
        ASSERT_TRUE(simulation.step(loads));
    }
    EXPECT_EQ(simulation.positions(), tissue.model.network->restPositions);
}

TEST(Contact, RestingInstrumentDoesNotMakeTheTissueTremble) {
    const Tissue tissue = membrane(21, soft, Integrator::Auto);
    Simulation simulation(tissue.model, tissue.settings, tissue.surface);
    Loads loads;
    for (int i = 0; i < 600; ++i) {
        loads.instruments = {sphereAt({0.003, 0.002, std::max(-0.002, 0.012 - 0.0002 * i)}, 0.01)};
        ASSERT_TRUE(simulation.step(loads));
    }
    for (const Vector3d& velocity : simulation.velocities())
        EXPECT_LT(velocity.norm(), 1e-4);
    EXPECT_LT(simulation.positions()[220].z(), -0.01);
}

TEST(Contact, ContactDragsTheNeighboursOfLedNodesNotTheLedOnes) {
    const Tissue tissue = membrane(21, soft, Integrator::Split);
    Simulation simulation(tissue.model, tissue.settings, tissue.surface);
    Loads loads;
    loads.prescribed = {{220, tissue.model.network->restPositions[220] + Vector3d(0, 0, 0.002)}};
    for (int i = 0; i < 100; ++i) {
        loads.instruments = {sphereAt({0.025, 0, 0.02 - 0.0002 * i}, 0.01)};
        ASSERT_TRUE(simulation.step(loads));
        EXPECT_EQ(simulation.positions()[220], loads.prescribed[0].position);
        EXPECT_LT(penetration(tissue.surface, simulation.positions(), loads.instruments.front()), 1e-6);
    }
}

TEST(Contact, ASphereThatSwallowsTheOrganPushesItOut) {
    const TriangleMesh mesh = tissue::sphereMesh(3, 0.01);
    Tissue organ{tissue::fromMesh(mesh, soft), mesh.triangles};
    Simulation simulation(organ.model, organ.settings, organ.surface);
    Loads loads;
    loads.instruments = {sphereAt({0.005, 0, 0}, 0.02)};
    for (int i = 0; i < 20; ++i)
        ASSERT_TRUE(simulation.step(loads)) << simulation.failure();
    EXPECT_LT(penetration(organ.surface, simulation.positions(), loads.instruments.front()), 1e-6);
}

constexpr double ballPoker = 0.01; ///< m, radius

/// Where a sphere leaves a small ball that it was pushed into.
Vectors poked(Integrator integrator, const std::optional<SpringStiffening>& law) {
    const TriangleMesh mesh = tissue::sphereMesh(2, 0.05);
    TissueModel model = tissue::fromMesh(mesh, {10, 0.02, 0.001});
    model.stiffening = law;
    Simulation simulation(model, withStep(integrator, 0.001), mesh.triangles);
    for (int i = 0; i <= 40; ++i) {
        Loads loads;
        loads.instruments = {sphereAt({0, 0, 0.062 - 0.0005 * i}, ballPoker)};
        EXPECT_TRUE(simulation.step(loads)) << simulation.failure();
    }
    EXPECT_TRUE(wasTouched(simulation));
    return simulation.positions();
}

TEST(Contact, ALawThatIsNotReachedChangesNothing) {
    for (const Integrator integrator : allIntegrators) {
        SCOPED_TRACE(integratorName(integrator));
        const Vectors linear = poked(integrator, {}), biphasic = poked(integrator, SpringStiffening{5, 100});
        for (std::size_t i = 0; i < linear.size(); ++i)
            EXPECT_LT((biphasic[i] - linear[i]).norm(), 1e-3 * ballPoker);
    }
}

TEST(Contact, AStepIsCutIntoPartsForABodyThatComesFastFromFarOff) {
    const TriangleMesh ball = tissue::sphereMesh(1, 0.01);
    TouchedSurface surface(ball.triangles);
    const Vectors line{{0, 0, 0}, {0, 0, 0.01}};
    surface.body = TouchedSurface::Body{ball.vertices, {0, 1}, line[0], line[1]};
    const std::vector<ColliderMove> farOff{{Sphere{0.01}, {{0.2, 0, 0}}, {{0.2, 0, 0}}}};
    const auto parts = [&](double speed) {
        return contactParts(surface, line, {{speed, 0, 0}, {speed, 0, 0}}, farOff, 0.1);
    };
    EXPECT_EQ(parts(0), 1);
    EXPECT_EQ(parts(0.5), 1) << "it does not come that far";
    EXPECT_GE(parts(3), 0.3 / 0.005) << "half a radius each";
}

} // namespace
