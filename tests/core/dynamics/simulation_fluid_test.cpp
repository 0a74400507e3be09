#include "core/dynamics/forces.h"
#include "core/dynamics/simulation.h"
#include "core/dynamics/stability/stability.h"
#include "core/support/errors.h"
#include "tests/support/every_integrator.h"
#include "tests/support/filled_ball.h"
#include "tests/support/sanitized.h"
#include "tests/support/simulation_settings.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

using namespace esm;
using Eigen::Vector3d;
using tissue::Vectors;

namespace {

constexpr double radius = tissue::ballRadius;
constexpr tissue::Parameters wall{30, 0.3, 1e-4};

const double burstPressure = tissue::mostPressure(wall.springConstant);

Vector3d middleOf(const Vectors& positions) {
    return std::accumulate(positions.begin(), positions.end(), Vector3d(0, 0, 0)) /
           static_cast<double>(positions.size());
}

double meanRadius(const Vectors& positions) {
    double sum = 0;
    for (const Vector3d& position : positions)
        sum += (position - middleOf(positions)).norm();
    return sum / static_cast<double>(positions.size());
}

/// N/m: what the springs across a plane through the middle pull with, over the length of the cut.
double tensionAcross(const Vector3d& normal, const TissueModel& model, const Vectors& positions) {
    const Vector3d middle = middleOf(positions);
    double pull = 0;
    for (std::size_t i = 0; i < model.network->springs.size(); ++i) {
        const auto& [first, second, restLength] = model.network->springs[i];
        const Vector3d between = positions[second] - positions[first];
        const double from = normal.dot(positions[first] - middle),
                     to = normal.dot(positions[second] - middle);
        if (from * to >= 0) continue;
        const double force = valuesOf(model, i).springConstant * (between.norm() - restLength);
        pull += force * std::abs(normal.dot(between)) / between.norm();
    }
    return pull / (2 * std::acos(-1.0) * meanRadius(positions));
}

/// After so many steps, in which everything came to rest.
Vectors settled(const TissueModel& model, const SimulationSettings& settings, const Loads& loads, int steps) {
    Simulation simulation(model, settings);
    EXPECT_EQ(simulation.advance(loads, static_cast<std::size_t>(steps)), static_cast<std::size_t>(steps))
        << simulation.failure();
    EXPECT_LT(simulation.energy().kinetic, 1e-6 * simulation.energy().elastic);
    return simulation.positions();
}

} // namespace

TEST(PressedBall, HasTheTensionOfLaplacesLaw) {
    for (const double share : isSanitized() ? std::vector{0.5} : std::vector{0.05, 0.2, 0.5, 0.8, 0.95}) {
        const double pressure = share * burstPressure;
        const TissueModel model = tissue::filledBall(3, wall, {0, pressure});
        const Vectors ball =
            settled(model, withStep(Integrator::Implicit, 0.01), tissue::pressing(pressure), 400);
        const double expected = pressure * meanRadius(ball) / 2;
        for (const Vector3d& normal :
             {Vector3d(0.36, 0.48, 0.8), Vector3d(0.8, -0.6, 0.01), Vector3d(-0.1, 0.7, 0.7)})
            EXPECT_NEAR(tensionAcross(normal.normalized(), model, ball), expected, 0.01 * expected) << share;
        const double width = tissue::widthUnder(share);
        EXPECT_NEAR(meanRadius(ball) / radius, width, 0.01 * width) << share;
    }
}

TEST(PressedBall, BurstsWhereItsWallCanHoldNoMore) {
    for (const Integrator integrator : {Integrator::Implicit, Integrator::Split, Integrator::Euler}) {
        if (isSanitized() && isExplicit(integrator)) continue; // too many short steps
        for (const double share : {0.97, 1.05}) {
            const double pressure = share * burstPressure;
            const TissueModel model = tissue::filledBall(2, wall, {0, pressure});
            SimulationSettings settings;
            settings.integrator = integrator;
            Simulation simulation(model, settings);
            const auto steps = static_cast<std::size_t>(10 / simulation.timeStep());
            const bool holds = simulation.advance(tissue::pressing(pressure), steps) == steps;
            EXPECT_EQ(holds, share < 1) << integratorName(integrator);
            EXPECT_EQ(simulation.failure().find("bursts part 1") != std::string::npos, share > 1)
                << simulation.failure();
            for (const Vector3d& position : simulation.positions())
                ASSERT_TRUE(position.allFinite());
        }
    }
}

TEST(PressedBall, IsTurnedInsideOutBySuctionAndSaysSo) {
    const double pressure = -4 * burstPressure;
    const TissueModel model = tissue::filledBall(2, wall, {0, -pressure});
    SimulationSettings settings;
    settings.integrator = Integrator::Implicit;
    Simulation simulation(model, settings);
    simulation.advance(tissue::pressing(pressure), static_cast<std::size_t>(20 / simulation.timeStep()));
    EXPECT_NE(simulation.failure().find("suction turned part 1"), std::string::npos) << simulation.failure();
}

namespace {

class FilledBall : public testing::TestWithParam<Integrator> {
protected:
    /// A step that the integrator bears.
    SimulationSettings settingsFor(const TissueModel& model, double most) const {
        return withStep(GetParam(), std::min(most, 0.8 * criticalStep(model, GetParam()).value()));
    }
};
INSTANTIATE_TEST_SUITE_P(Dynamics, FilledBall, testing::ValuesIn(allIntegrators), nameOfIntegratorTest);

} // namespace

TEST_P(FilledBall, ComesToTheSameRest) {
    if (isSanitized() && takesShortSteps(GetParam())) GTEST_SKIP() << "too many short steps";
    const double pressure = 0.4 * burstPressure;
    const TissueModel model = tissue::filledBall(1, wall, {2 * burstPressure, pressure});
    const SimulationSettings settings = settingsFor(model, 0.01);
    const int steps = static_cast<int>(2 / *settings.timeStep);
    const Vectors ball = settled(model, settings, tissue::pressing(pressure), steps);
    const Vectors expected =
        settled(model, withStep(Integrator::Implicit, 0.005), tissue::pressing(pressure), 1000);
    for (std::size_t i = 0; i < ball.size(); ++i)
        EXPECT_LT((ball[i] - expected[i]).norm(), 1e-5 * radius);
    EXPECT_GT(tissue::volumeOf(model, ball), 1.05 * tissue::volumeOf(model, model.network->restPositions));
}

// Both of its poles are led towards each other by a third of the radius.
TEST_P(FilledBall, KeepsItsVolumeWhenItIsSqueezed) {
    const TissueModel model = tissue::filledBall(1, wall, {1e6, 0});
    const SimulationSettings settings = settingsFor(model, 0.002);
    Simulation simulation(model, settings);
    const Vectors& rest = model.network->restPositions;
    const double volume = tissue::volumeOf(model, rest);
    Loads loads;
    for (double time = 0; time < 0.2; time += *settings.timeStep) {
        const double way = std::min(0.3 * radius, 0.3 * radius * time / 0.1);
        loads.prescribed.clear();
        for (std::uint32_t node = 0; node < rest.size(); ++node)
            if (std::abs(rest[node].z()) > 0.8 * radius)
                loads.prescribed.push_back(
                    {node, rest[node] - Vector3d(0, 0, std::copysign(way, rest[node].z()))});
        ASSERT_TRUE(simulation.step(loads)) << simulation.failure();
        ASSERT_NEAR(tissue::volumeOf(model, simulation.positions()), volume, 1e-3 * volume) << time;
    }
    ASSERT_GE(loads.prescribed.size(), 2U);
    double widest = 0;
    for (const Vector3d& position : simulation.positions())
        widest = std::max(widest, std::hypot(position.x(), position.y()));
    EXPECT_GT(widest, 1.03 * radius); // it gives way to the sides
}

// An instrument gives way to nothing: the fluid does, all around.
TEST_P(FilledBall, KeepsItsVolumeWhenAnInstrumentPokesIt) {
    if (isSanitized() && takesShortSteps(GetParam())) GTEST_SKIP() << "too many short steps";
    const TissueModel model = tissue::filledBall(2, wall, {1e6, 0});
    const SimulationSettings settings = settingsFor(model, 0.002);
    const TriangleMesh mesh = tissue::sphereMesh(2, radius);
    Simulation simulation(model, settings, mesh.triangles);
    const double volume = tissue::volumeOf(model, model.network->restPositions);
    Loads loads;
    for (std::uint32_t node = 0; node < model.mass.size(); ++node)
        if (mesh.vertices[node].z() < -0.8 * radius) loads.prescribed.push_back({node, mesh.vertices[node]});
    constexpr double tip = 0.3 * radius;
    for (double time = 0; time < 0.2; time += *settings.timeStep) {
        const double way = std::min(0.3 * radius, 0.3 * radius * time / 0.1);
        loads.instruments = {sphereAt({0, 0, radius + tip - way}, tip)};
        ASSERT_TRUE(simulation.step(loads)) << simulation.failure();
        ASSERT_NEAR(tissue::volumeOf(model, simulation.positions()), volume, 1e-3 * volume) << time;
    }
    EXPECT_TRUE(simulation.instrumentTouches().at(0).touched);
}

namespace {

struct Momenta {
    Vector3d linear = Vector3d::Zero(), angular = Vector3d::Zero();
};

Momenta momentaOf(const TissueModel& model, const Simulation& simulation) {
    Momenta sum;
    for (std::size_t i = 0; i < model.mass.size(); ++i) {
        sum.linear += model.mass[i] * simulation.velocities()[i];
        sum.angular += model.mass[i] * simulation.positions()[i].cross(simulation.velocities()[i]);
    }
    return sum;
}

} // namespace

// A fluid adds nothing to the momentum of the whole. Of the angular momentum steps that solve lose as much as
// they do without a fluid.
TEST_P(FilledBall, KeepsItsMomentumInFreeFlight) {
    const double pressure = 0.3 * burstPressure;
    const auto flown = [&](const tissue::Fluid& fluid) {
        const TissueModel model =
            tissue::filledBall(1, {30, GetParam() == Integrator::Split2 ? 0.02 : 0.0, 1e-4}, fluid);
        const TissueModel stiffest = tissue::filledBall(1, {30, 0.02, 1e-4}, {3000, pressure});
        const SimulationSettings settings =
            withStep(GetParam(), std::min(1e-4, 0.5 * criticalStep(stiffest, GetParam()).value()));
        Simulation simulation(model, settings);
        Loads kick = tissue::pressing(fluid.largestPressure);
        for (std::uint32_t i = 0; i < model.mass.size(); ++i) {
            const Vector3d& x = model.network->restPositions[i];
            const Vector3d velocity =
                Vector3d(0.3, 0.1, 0) + Vector3d(0, 2, 8).cross(x) + 20 * Vector3d(x.z(), 0, 0);
            kick.forces.emplace_back(i, model.mass[i] / *settings.timeStep * velocity);
        }
        EXPECT_TRUE(simulation.step(kick));
        const Momenta before = momentaOf(model, simulation);
        for (double time = 0; time < 0.1; time += *settings.timeStep)
            EXPECT_TRUE(simulation.step(tissue::pressing(fluid.largestPressure))) << simulation.failure();
        const Momenta after = momentaOf(model, simulation);
        return std::pair((after.linear - before.linear).norm() / before.linear.norm(),
                         (after.angular - before.angular).norm() / before.angular.norm());
    };
    const auto [linear, angular] = flown({3000, pressure});
    EXPECT_LT(linear, GetParam() == Integrator::Propagation ? 1e-4 : 1e-9);
    EXPECT_LT(angular, std::max(1e-9, 1.5 * flown({0, 0}).second + 1e-3));
}

namespace {

/// Whether the energy of a small kick everywhere grows a millionfold.
bool runsAway(const TissueModel& model, const SimulationSettings& settings) {
    Simulation simulation(model, settings);
    Loads kick;
    for (std::uint32_t i = 0; i < model.mass.size(); ++i)
        kick.forces.emplace_back(i,
                                 1e-7 * model.mass[i] / *settings.timeStep *
                                     (Vector3d(std::sin(9.1 * i), std::cos(5.3 * i), std::sin(3.7 * i + 1)) +
                                      model.network->restPositions[i] / radius));
    EXPECT_TRUE(simulation.step(kick));
    const double given = simulation.energy().total();
    constexpr std::size_t together = 100;
    for (int i = 0; i < 100; ++i)
        if (simulation.advance({}, together) < together || simulation.energy().total() > 1e6 * given)
            return true;
    return false;
}

// Heun's and Adams and Moulton's bounds hold for any tissue as little damped as this one is at the least:
// they may be short of its own.
double loosest(Integrator integrator) {
    const bool isBoundByDamping = integrator == Integrator::Heun || integrator == Integrator::AdamsMoulton;
    return isBoundByDamping ? 2 : 1.05;
}

} // namespace

// Where a fluid resists more than the springs do, it alone limits explicit steps; where less, hardly; and
// steps that take it implicitly not at all.
TEST(FilledBalls, ExplicitStepsRunAwayWhereTheyArePredictedTo) {
    for (const Integrator integrator : explicitIntegrators())
        for (const double stiffness : {1e3, 1e5, 1e6}) {
            const TissueModel model = tissue::filledBall(2, {30, 0.005, 1e-4}, {stiffness, 0});
            const double critical = criticalStep(model, integrator, {1e-3, Deformation::AtRest, {}}).value();
            EXPECT_FALSE(runsAway(model, withStep(integrator, 0.98 * critical)))
                << integratorName(integrator) << stiffness;
            EXPECT_TRUE(runsAway(model, withStep(integrator, loosest(integrator) * critical)))
                << integratorName(integrator) << stiffness;
        }
}

TEST(FilledBalls, DoNotShortenStepsThatTakeTheFluidImplicitly) {
    for (const Integrator integrator : {Integrator::Split, Integrator::Split2}) {
        const tissue::Parameters parameters{30, 0.02, 1e-4};
        const TissueModel empty = tissue::fromMesh(tissue::sphereMesh(2, radius), parameters),
                          full = tissue::filledBall(2, parameters, {1e6, 0});
        const StabilitySearch search{1e-3, Deformation::AtRest, {}};
        const double critical = criticalStep(empty, integrator, search).value();
        EXPECT_NEAR(criticalStep(full, integrator, search).value(), critical, 2e-3 * critical);
        EXPECT_FALSE(runsAway(full, withStep(integrator, 0.98 * critical)));
        EXPECT_TRUE(runsAway(full, withStep(integrator, 1.05 * critical)));
    }
}

TEST(FilledBalls, MoveAlikeWithAnyNumberOfThreads) {
    const TissueModel model = tissue::filledBall(4, wall, {3e4, 100});
    for (const Precision precision : {Precision::Double, Precision::Float}) {
        const auto after = [&](std::size_t threads) {
            SimulationSettings settings = withStep(Integrator::Euler, 1e-5);
            settings.threads = threads;
            settings.precision = precision;
            Simulation simulation(model, settings);
            Loads loads = tissue::pressing(100);
            loads.gravity = {0, 1, -9.81};
            EXPECT_EQ(simulation.advance(loads, 100), 100U);
            return simulation.positions();
        };
        const Vectors alone = after(1);
        EXPECT_EQ(after(2), alone);
        EXPECT_EQ(after(3), alone);
    }
}

TEST(FilledBalls, TakeNoPressureThatNoPartHas) {
    Simulation dry(tissue::fromMesh(tissue::sphereMesh(1, radius), wall), withStep(Integrator::Split, 1e-3));
    EXPECT_FALSE(dry.step(tissue::pressing(10)));
    EXPECT_THAT(dry.failure(), testing::HasSubstr("not filled"));
    Simulation filled(tissue::filledBall(1, wall, {}), withStep(Integrator::Split, 1e-3));
    EXPECT_FALSE(filled.step(tissue::pressing(std::nan(""))));
    EXPECT_TRUE(filled.step(tissue::pressing(10)));
}
