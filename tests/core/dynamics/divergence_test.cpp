#include "core/dynamics/divergence.h"
#include "core/dynamics/simulation.h"
#include "tests/support/simulation_settings.h"
#include "tests/support/tissue_models.h"

#include <gtest/gtest.h>

using namespace esm;
using tissue::Vectors;

namespace {

constexpr double timeStep = 1e-5; // s

/// A net and what a guard says of where it goes.
struct Watched {
    SpringSystem system = makeSpringSystem(tissue::fromMesh(tissue::gridMesh(5, 0.1), {10, 0.1, 0.001}));
    Vectors rest = system.network->restPositions, still = Vectors(25, Eigen::Vector3d::Zero());
    DivergenceGuard guard;

    Watched() { guard.restart(rest); }

    std::string stretched(double factor, const Loads& loads, const std::vector<double>& instrumentWays = {}) {
        Vectors after = rest;
        for (Eigen::Vector3d& position : after)
            position *= factor;
        return guard.problemOf({system, rest, after, still, loads, instrumentWays, timeStep});
    }
};

Loads instrumentAt(const Eigen::Vector3d& centre) {
    Loads loads;
    loads.instruments = {sphereAt(centre, 0.01)};
    return loads;
}

} // namespace

TEST(DivergenceGuard, JudgesEnergyAlsoAfterAnInstrumentAppeared) {
    Watched net;
    const Loads beside = instrumentAt({0, 0, 0.02});
    EXPECT_EQ(net.stretched(1, beside), "");
    EXPECT_NE(net.stretched(10, beside, {0}), "");
}

TEST(DivergenceGuard, LetsAnInstrumentThrustAsideWhatItAppearsIn) {
    Watched net;
    EXPECT_EQ(net.stretched(10, instrumentAt({0, 0, 0})), "");
    EXPECT_EQ(net.stretched(10, {}), "");
    EXPECT_NE(net.stretched(40, {}), "");
}

TEST(DivergenceGuard, LetsAFastInstrumentDriveTissueFar) {
    Watched net;
    EXPECT_EQ(net.stretched(10, instrumentAt({0, 0, 0}), {100 * timeStep}), "");
}

TEST(DivergenceGuard, LetsAPartThatNothingHoldsFall) {
    TriangleMesh mesh = tissue::gridMesh(3, 0.02);
    const TriangleMesh other = mesh;
    for (const Eigen::Vector3d& vertex : other.vertices)
        mesh.vertices.push_back(vertex + Eigen::Vector3d(0.05, 0, 0));
    for (const auto& [a, b, c] : other.triangles)
        mesh.triangles.push_back({a + 9, b + 9, c + 9});
    TissueModel model = tissue::fromMesh(mesh, {10, 0.1, 0.001});
    for (std::uint32_t node = 0; node < 9; ++node)
        model.fixedNodes.push_back(node);
    for (const Integrator integrator : {Integrator::Split2, Integrator::Euler, Integrator::Projective}) {
        Simulation simulation(model, withStep(integrator, 0.001));
        Loads loads;
        loads.gravity = {0, 0, -9.81};
        EXPECT_EQ(simulation.advance(loads, 3000), 3000U) << simulation.failure();
        EXPECT_NEAR(simulation.positions()[17].z(), -0.5 * 9.81 * 9, 0.05) << integratorName(integrator);
    }
}
