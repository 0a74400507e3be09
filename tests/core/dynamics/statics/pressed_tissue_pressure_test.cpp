#include "core/dynamics/forces.h"
#include "core/dynamics/simulation.h"
#include "core/dynamics/statics/pressed_tissue.h"
#include "tests/support/filled_ball.h"
#include "tests/support/sanitized.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace esm {
namespace {

using Eigen::Vector3d;

constexpr double balloonConstant = 30; ///< N/m
const double balloonBears = tissue::mostPressure(balloonConstant);

/// A ball on tethers whose lower nodes are fixed, and as it rests under its pressure.
struct Balloon {
    Balloon(int levels, double stiffness, double share, double tether = 1)
        : mesh(tissue::sphereMesh(levels, tissue::ballRadius)), pressure(share * balloonBears),
          model(tissue::filled(mesh, {balloonConstant, 0.3, 1e-4}, {stiffness, pressure})) {
        for (std::uint32_t node = 0; node < mesh.vertices.size(); ++node) {
            model.tethers.push_back({node, tether, 0.1});
            if (mesh.vertices[node].z() < -0.8 * tissue::ballRadius) model.fixedNodes.push_back(node);
        }
        system = makeSpringSystem(model);
        rest = inflated(system, tissue::pressing(pressure).pressures);
    }
    /// Of so many radii, from above.
    Indenter finger(double radii) const {
        double top = 0;
        for (const Vector3d& place : rest.positions)
            top = std::max(top, place.z());
        return {radii * tissue::ballRadius, {0, 0, top + radii * tissue::ballRadius}, -Vector3d::UnitZ()};
    }
    PressedTissue pressedBy(const Indenter& finger) const {
        return PressedTissue(system, rest, mesh.triangles, finger);
    }

    TriangleMesh mesh;
    double pressure; ///< Pa
    TissueModel model;
    SpringSystem system;
    InflatedTissue rest;
};

// What the finger does on a small way is what springs, tethers and fluid store, less what the pressure does.
TEST(PressedTissueUnderPressure, StoresTheWorkOfTheFinger) {
    for (const double stiffness : {0.0, balloonBears}) {
        const Balloon balloon(3, stiffness, 0.7);
        PressedTissue tissue = balloon.pressedBy(balloon.finger(0.5));
        constexpr double depth = 0.2 * tissue::ballRadius, way = 0.002 * tissue::ballRadius;
        std::vector<double> energies, forces;
        for (const double at : {depth - way, depth, depth + way}) {
            tissue.settle(AtDepth{at});
            energies.push_back(energy(balloon.system, tissue.positions(), {}).elastic -
                               balloon.pressure * volumesOf(balloon.system, tissue.positions()).front());
            forces.push_back(tissue.force());
        }
        EXPECT_NEAR((energies[2] - energies[0]) / (2 * way), forces[1], 0.003 * forces[1]) << stiffness;
    }
}

/// N, of an instrument in a run that first comes to rest under the pressure, and then beneath it.
double simulatedForce(const Balloon& balloon, const Indenter& finger, double depth) {
    Simulation simulation(balloon.model, {}, TouchedSurface(balloon.mesh.triangles));
    Loads loads = tissue::pressing(balloon.pressure);
    constexpr double inflated = 2, arrived = 3, settled = 5, told = 5.5; // s
    const auto run = [&](double end) {
        const double begin = simulation.time();
        while (simulation.time() < end) {
            const double part =
                std::min(1.0, (simulation.time() + simulation.timeStep() - inflated) / (arrived - inflated));
            if (end > inflated)
                loads.instruments = {sphereAt(finger.start + part * depth * finger.inwards, finger.radius)};
            EXPECT_TRUE(simulation.step(loads)) << simulation.failure();
        }
        return simulation.time() - begin;
    };
    run(inflated);
    run(settled);
    const Vector3d before = simulation.instrumentTouches()[0].impulse;
    const double duration = run(told);
    return (simulation.instrumentTouches()[0].impulse - before).z() / duration;
}

TEST(PressedTissueUnderPressure, HasTheForceThatASimulationComesTo) {
    const Balloon balloon(3, 0, 0.6);
    const Indenter finger = balloon.finger(1);
    constexpr double depth = 0.2 * tissue::ballRadius;
    PressedTissue tissue = balloon.pressedBy(finger);
    tissue.settle(AtDepth{depth});
    const double force = simulatedForce(balloon, finger, depth);
    EXPECT_GT(force, 0);
    EXPECT_NEAR(tissue.force(), force, 0.01 * force);
    PressedTissue limp(balloon.system, balloon.mesh.triangles,
                       {finger.radius, {0, 0, tissue::ballRadius + finger.radius}, finger.inwards});
    limp.settle(AtDepth{depth});
    EXPECT_GT(tissue.force(), 1.2 * limp.force()) << "the pressure resists";
}

/// m², of the triangles that lie on the sphere with all of their corners. The wall's next ring of nodes
/// bears a share of what is beneath it, so that on average this is neither too large nor too small.
double contactArea(const Vectors& places, const std::vector<Triangle>& surface, const Vector3d& centre,
                   double radius) {
    const auto touches = [&](std::uint32_t node) {
        return (places[node] - centre).norm() < radius + 3e-4 * tissue::ballRadius;
    };
    double area = 0;
    for (const Triangle& triangle : surface)
        if (std::all_of(triangle.begin(), triangle.end(), touches))
            area += areaNormal(places, triangle).norm() / 2;
    return area;
}

// Beneath a sphere that is large beside it a light wall lies nearly flat, and the sphere bears the pressure
// where they touch. At the edge, a from the middle, the wall's tension p·r/2 leaves it at the slope a/R,
// which adds r/R of that.
TEST(PressedTissueUnderPressure, PressesABalloonWithItsPressureTimesTheContactArea) {
    if (isSanitized()) GTEST_SKIP() << "smaller bodies show the sanitizers the same";
    const Balloon balloon(4, 0, 0.5, 1e-3);
    const Indenter finger = balloon.finger(10);
    const double times = finger.start.z() / finger.radius; // 1 + r/R
    PressedTissue tissue = balloon.pressedBy(finger);
    double force = 0, expected = 0; // of several depths, since the area grows by whole triangles
    for (const double share : {0.2, 0.25, 0.3, 0.4}) {
        const double depth = share * tissue::ballRadius;
        tissue.settle(AtDepth{depth});
        force += tissue.force();
        expected += times * balloon.pressure *
                    contactArea(tissue.positions(), balloon.mesh.triangles,
                                finger.start + depth * finger.inwards, finger.radius);
    }
    EXPECT_NEAR(force, expected, 0.03 * expected);
}

TEST(PressedTissueUnderPressure, LeavesTheFingerAloneWhereItOnlyTouches) {
    const Balloon balloon(2, 0, 0.6);
    PressedTissue tissue = balloon.pressedBy(balloon.finger(0.5));
    tissue.settle(AtDepth{0});
    EXPECT_NEAR(tissue.force(), 0, 1e-6 * balloon.pressure * tissue::ballRadius * tissue::ballRadius);
    for (int i = 0; i < 10; ++i)
        tissue.step(AtDepth{-0.1 * tissue::ballRadius}, 0.1);
    for (std::size_t i = 0; i < balloon.rest.positions.size(); ++i)
        EXPECT_LT((tissue.positions()[i] - balloon.rest.positions[i]).norm(), 1e-5 * tissue::ballRadius)
            << "it rests as time goes on";
}

TEST(PressedTissueUnderPressure, CreepsToTheDepthWhereItRestsUnderAForce) {
    const Balloon balloon(2, 0, 0.6);
    PressedTissue creeping = balloon.pressedBy(balloon.finger(0.5)), resting = creeping;
    resting.settle(AtDepth{0.2 * tissue::ballRadius});
    double before = 0;
    for (double time = 0.001; time < 100; time *= 1.5) {
        creeping.step(UnderForce{resting.force()}, time);
        EXPECT_GE(creeping.depth(), before - 1e-4 * tissue::ballRadius);
        before = creeping.depth();
    }
    EXPECT_NEAR(creeping.depth(), 0.2 * tissue::ballRadius, 1e-3 * 0.2 * tissue::ballRadius);
}

TEST(PressedTissueUnderPressure, FeelsTheSameInOneStepAndInManyNextToBursting) {
    const Balloon balloon(2, 0, 0.95, 1e-3);
    PressedTissue once = balloon.pressedBy(balloon.finger(0.5)), often = once;
    once.settle(AtDepth{0.3 * tissue::ballRadius});
    for (int i = 1; i <= 6; ++i)
        often.settle(AtDepth{0.05 * i * tissue::ballRadius});
    EXPECT_NEAR(once.force(), often.force(), 0.002 * once.force());
}

} // namespace
} // namespace esm
