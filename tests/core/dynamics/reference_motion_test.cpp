#include "tests/support/reference_motion.h"

#include "core/dynamics/measure/scene_run.h"
#include "tests/support/tissue_models.h"

#include <gtest/gtest.h>

#include <cmath>

namespace esm {
namespace {

using reference::Experiment;
using reference::placesAt;

constexpr double exactly = 1e-13; // m, of each step

std::vector<double> everyTime(double interval, int count) {
    std::vector<double> times;
    for (int i = 1; i <= count; ++i)
        times.push_back(i * interval);
    return times;
}

/// A node of 1 g on a tether at the origin.
TissueModel tetheredNode(double springConstant, double viscosity) {
    SpringNetwork network;
    network.restPositions = {{0, 0, 0}};
    TissueModel model = tissue::model(network, {0, 0, 0.001});
    model.tethers = {{0, springConstant, viscosity}};
    return model;
}

Scene lasting(double duration) {
    Scene scene;
    scene.duration = duration;
    return scene;
}

/// Where an oscillator of mass 1 g is that a force of 1 N began to push so long ago, m.
double stepResponse(double springConstant, double viscosity, double time) {
    if (time <= 0) return 0;
    const double decay = viscosity / 0.002, square = springConstant / 0.001;
    const double spread = std::sqrt(std::abs(decay * decay - square));
    double homogeneous = 0;
    if (square > decay * decay)
        homogeneous =
            std::exp(-decay * time) * (std::cos(spread * time) + decay / spread * std::sin(spread * time));
    else
        homogeneous = (std::exp((spread - decay) * time) * (spread + decay) +
                       std::exp(-(spread + decay) * time) * (spread - decay)) /
                      (2 * spread);
    return (1 - homogeneous) / springConstant;
}

TEST(ReferenceMotion, OfADampedOscillatorThatIsPushedForAShortWhile) {
    for (const double viscosity : {0.0, 0.02, 2.0, 200.0}) { // free, light, heavy, creeping
        Scene scene = lasting(0.1);
        scene.forces = {{0, {1, 0, 0}, 0.01037, 0.010791}};
        const TissueModel model = tetheredNode(100, viscosity);
        const std::vector<double> times = everyTime(0.01, 10);
        const auto places = placesAt({model, scene}, times, exactly);
        const double most = 0.000421 / std::max(0.3, viscosity); // m, a bound of the way
        for (std::size_t i = 0; i < times.size(); ++i) {
            const double expected = stepResponse(100, viscosity, times[i] - 0.01037) -
                                    stepResponse(100, viscosity, times[i] - 0.010791);
            EXPECT_NEAR(places[i][0].x(), expected, 1e-7 * most) << viscosity << " at " << times[i];
        }
    }
}

TEST(ReferenceMotion, OfTwoMassesOnASpring) {
    const TissueModel model = tissue::oneSpring({10, 0.01, 0.001}, 0.05);
    Scene scene = lasting(0.5);
    scene.forces = {{1, {0.01, 0, 0}, 0, 1}};
    const std::vector<double> times = everyTime(0.1, 5);
    const auto places = placesAt({model, scene}, times, exactly);
    for (std::size_t i = 0; i < times.size(); ++i) {
        const double t = times[i];
        // Apart from each other they are one mass of half a gram, and 2·c of one gram.
        const double apart = 0.05 + 0.01 * stepResponse(20, 0.02, t);
        const double middle = 0.025 + 0.01 / 0.002 * t * t / 2;
        EXPECT_NEAR(places[i][0].x(), middle - apart / 2, 1e-10);
        EXPECT_NEAR(places[i][1].x(), middle + apart / 2, 1e-10);
    }
}

TEST(ReferenceMotion, OfASpringThatBecomesStiffer) {
    TissueModel model = tissue::oneSpring({10, 0, 0.001}, 0.05);
    model.stiffening = SpringStiffening{0.1, 4};
    model.fixedNodes = {0};
    Scene scene = lasting(0.03);
    scene.forces = {{1, {0.05, 0, 0}, 0, 1}};
    // F/c·(1 − cos ωt) up to the strain at 5 mm = F/c, a quarter of a swing; on from there with 2ω.
    const double frequency = std::sqrt(10 / 0.001), met = std::acos(0.0) / frequency;
    const double speed = 0.005 * frequency;
    const std::vector<double> times{met / 2, met, 0.02, 0.03};
    const auto places = placesAt({model, scene}, times, exactly);
    EXPECT_NEAR(places[0][1].x(), 0.05 + 0.005 * (1 - std::cos(frequency * met / 2)), 1e-11);
    EXPECT_NEAR(places[1][1].x(), 0.055, 1e-11);
    for (const std::size_t later : {std::size_t{2}, std::size_t{3}})
        EXPECT_NEAR(places[later][1].x(),
                    0.055 + speed / (2 * frequency) * std::sin(2 * frequency * (times[later] - met)), 1e-11);
}

TEST(ReferenceMotion, FollowsALedNode) {
    const TissueModel model = tissue::oneSpring({10, 0.01, 0.001}, 0.05);
    Scene scene = lasting(0.2);
    scene.moves = {{0, {{0.033, {0, 0, 0}}, {0.133, {-0.02, 0, 0}}}}};
    // Seen from the led node the other one swings as after a jump of its velocity.
    const double decay = 0.01 / 0.002, spread = std::sqrt(10 / 0.001 - decay * decay);
    const auto lag = [&](double since) {
        return since > 0 ? 0.2 / spread * std::exp(-decay * since) * std::sin(spread * since) : 0;
    };
    const std::vector<double> times = everyTime(0.02, 10);
    const auto places = placesAt({model, scene}, times, exactly);
    for (std::size_t i = 0; i < times.size(); ++i) {
        const double led = -0.2 * std::clamp(times[i] - 0.033, 0.0, 0.1);
        EXPECT_NEAR(places[i][0].x(), led, 1e-15);
        EXPECT_NEAR(places[i][1].x(), 0.05 + led + lag(times[i] - 0.033) - lag(times[i] - 0.133), 1e-10);
    }
}

TEST(ReferenceMotion, FallsAndStaysWhereItIsFixed) {
    TissueModel model = tetheredNode(0, 0);
    Scene scene = lasting(1);
    scene.gravity = {0, -9.81, 0};
    EXPECT_NEAR(placesAt({model, scene}, {0.5}, exactly)[0][0].y(), -9.81 / 8, 1e-11);
    model.fixedNodes = {0};
    EXPECT_EQ(placesAt({model, scene}, {0.5}, exactly)[0][0].norm(), 0);
}

/// Over two equal times, by how much the second turn falls short of the first, once a couple has set two
/// joined nodes turning.
double lostTurn(Damping damping) {
    const TissueModel model = tissue::oneSpring({1000, 1, 0.001}, 0.05);
    Scene scene = lasting(0.05);
    scene.forces = {{0, {0, -0.1, 0}, 0, 0.002}, {1, {0, 0.1, 0}, 0, 0.002}};
    const auto places = placesAt({model, scene, damping}, {0.03, 0.04, 0.05}, exactly);
    const auto angle = [&](std::size_t time) {
        const Eigen::Vector3d between = places[time][1] - places[time][0];
        return std::atan2(between.y(), between.x());
    };
    return 1 - (angle(2) - angle(1)) / (angle(1) - angle(0));
}

TEST(ReferenceMotion, TurnsForEverWhereSpringsDampAlongTheirAxesAlone) {
    EXPECT_NEAR(lostTurn(Damping::Axial), 0, 1e-7);
    EXPECT_GT(lostTurn(Damping::Isotropic), 0.5);
}

TEST(ReferenceMotion, ComesNearerWithEachTolerance) {
    TissueModel model = tissue::fromMesh(tissue::gridMesh(4, 0.05), {100, 0.05, 0.001});
    model.fixedNodes = {0};
    model.stiffening = SpringStiffening{0.05, 3};
    Scene scene = lasting(0.1);
    scene.forces = {{15, {0.3, 0.2, 0.5}, 0.00137, 0.02}};
    scene.moves = {{3, {{0, {0, 0, 0}}, {0.0111, {0.01, 0, 0.01}}, {0.07, {0, 0, 0.02}}}}};
    const Experiment experiment{model, scene, Damping::Axial};
    const std::vector<double> times = everyTime(0.02, 5);
    const auto exact = reference::exactMotion(experiment, times);
    EXPECT_LT(exact.error, 1e-7);
    const auto off = [&](double tolerance) {
        return reference::relativeDifference(placesAt(experiment, times, tolerance), exact.places,
                                             model.network->restPositions);
    };
    EXPECT_LT(off(1e-9), off(1e-7) / 10);
    EXPECT_LT(off(1e-11), off(1e-9) / 10);
}

// Where loads change between steps only, shorter steps of the program end where the witness says: both solve
// the same equations.
TEST(ReferenceMotion, IsWhereTheProgramsStepsEnd) {
    TissueModel model = tissue::fromMesh(tissue::gridMesh(4, 0.05), {100, 0.05, 0.001});
    model.fixedNodes = {0};
    model.stiffening = SpringStiffening{0.05, 3};
    model.tethers = {{5, 20, 0.02}};
    model.springConstant[7] = 300;
    model.viscosity[8] = 0.2;
    Scene scene = lasting(0.05);
    scene.gravity = {0, 0, -9.81};
    scene.forces = {{15, {0.3, 0.2, 0.5}, 0.01, 0.02}};
    scene.moves = {{3, {{0, {0, 0, 0}}, {0.02, {0.01, 0, 0.01}}, {0.04, {0, 0, 0.02}}}}};
    scene.record.every = 0.025;
    for (const Damping damping : {Damping::Isotropic, Damping::Axial}) {
        SimulationSettings settings;
        settings.integrator = Integrator::Rk4;
        settings.timeStep = 1e-5;
        settings.damping = damping;
        std::vector<reference::Vectors> frames;
        const auto keep = [&](double, const std::vector<Eigen::Vector3d>& places) {
            frames.push_back(places);
        };
        runScene({model, {}, scene, settings}, keep);
        const auto exact = reference::exactMotion({model, scene, damping}, {0, 0.025, 0.05});
        EXPECT_LT(reference::relativeDifference(frames, exact.places, model.network->restPositions), 1e-6);
    }
}

} // namespace
} // namespace esm
