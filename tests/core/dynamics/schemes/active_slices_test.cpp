#include "core/dynamics/simulation.h"
#include "tests/support/every_integrator.h"
#include "tests/support/sanitized.h"
#include "tests/support/simulation_settings.h"
#include "tests/support/tissue_models.h"
#include "tests/support/was_touched.h"

#include <gtest/gtest.h>

#include <functional>

using namespace esm;
using Eigen::Vector3d;
using tissue::Vectors;

namespace {

constexpr double restTolerance = 1e-6; // m
constexpr double shortStep = 6e-5;     // s, stable with every integrator

const tissue::Parameters weaklyDamped{40, 0.002, 1e-5}, stronglyDamped{40, 0.008, 1e-5};

/// Its nodes 5 mm apart.
TissueModel membrane(int perSide, const tissue::Parameters& parameters) {
    return tissue::fromMesh(tissue::gridMesh(perSide, 0.005 * (perSide - 1)), parameters);
}

/// Each `every`-th node tethered.
TissueModel tethered(TissueModel model, std::uint32_t every) {
    for (std::uint32_t i = 0; i < model.mass.size(); i += every)
        model.tethers.push_back({i, model.springConstant[i] / 4, model.viscosity[i]});
    return model;
}

/// A strip of triangles, fixed at its first two nodes.
TissueModel strip(std::uint32_t length, const tissue::Parameters& parameters) {
    TriangleMesh mesh;
    for (std::uint32_t i = 0; i < length; ++i) {
        mesh.vertices.emplace_back(0.005 * i, 0, 0);
        mesh.vertices.emplace_back(0.005 * i, 0.005, 0);
    }
    for (std::uint32_t i = 0; i + 2 < 2 * length; ++i)
        mesh.triangles.push_back({i, i + 1, i + 2});
    TissueModel model = tissue::fromMesh(mesh, parameters);
    model.fixedNodes = {0, 1};
    return model;
}

/// Runs a scene and records the positions every few steps.
class FilmedRun {
public:
    FilmedRun(const TissueModel& model, const SimulationSettings& settings,
              std::vector<Triangle> surface = {})
        : m_simulation(model, settings, std::move(surface)) {}

    Simulation& simulation() { return m_simulation; }
    const std::vector<Vectors>& frames() const { return m_frames; }

    FilmedRun& run(const Loads& loads, int frames, std::size_t stepsPerFrame = 100) {
        for (int frame = 0; frame < frames; ++frame) {
            EXPECT_EQ(m_simulation.advance(loads, stepsPerFrame), stepsPerFrame) << m_simulation.failure();
            m_frames.push_back(m_simulation.positions());
        }
        return *this;
    }

private:
    Simulation m_simulation;
    std::vector<Vectors> m_frames;
};

Loads force(std::uint32_t node, const Vector3d& force) {
    Loads loads;
    loads.forces = {{node, force}};
    return loads;
}

double largestDifference(const FilmedRun& a, const FilmedRun& b) {
    double largest = 0;
    for (std::size_t frame = 0; frame < a.frames().size(); ++frame)
        for (std::size_t i = 0; i < a.frames()[frame].size(); ++i)
            largest = std::max(largest, (a.frames()[frame][i] - b.frames()[frame][i]).norm());
    return largest;
}

double largestWay(const FilmedRun& recording) {
    const Vectors& rest = recording.frames().front();
    double largest = 0;
    for (const Vectors& frame : recording.frames())
        for (std::size_t i = 0; i < frame.size(); ++i)
            largest = std::max(largest, (frame[i] - rest[i]).norm());
    return largest;
}

/// Whole and in part: the part's motion must be the whole's. Returns the share that the part computed.
double compare(const std::function<FilmedRun(const SimulationSettings&)>& record,
               Integrator integrator = Integrator::Euler) {
    SimulationSettings settings = withStep(integrator, shortStep);
    settings.threads = 1;
    FilmedRun whole = record(settings);
    settings.restTolerance = restTolerance;
    FilmedRun part = record(settings);
    EXPECT_EQ(whole.simulation().activeFraction(), 1);
    EXPECT_GT(largestWay(whole), 100 * restTolerance);
    const double difference = largestDifference(whole, part);
    EXPECT_LT(difference, restTolerance);
    return part.simulation().activeFraction();
}

} // namespace

std::vector<tissue::Parameters> dampings() {
    if (isSanitized()) return {stronglyDamped};
    return {weaklyDamped, stronglyDamped};
}

TEST(ActiveSlices, ALocalPokeMovesAsInTheWholeTissue) {
    for (const tissue::Parameters& parameters : dampings()) {
        const TissueModel model = tethered(membrane(40, parameters), 1);
        for (const Integrator integrator : explicitIntegrators()) {
            if (isSanitized() && integrator == Integrator::Rk4) continue; // adams-moulton begins with it
            SCOPED_TRACE(std::string(integratorName(integrator)) + ", viscosity " +
                         std::to_string(parameters.viscosity));
            const double active = compare(
                [&](const SimulationSettings& settings) {
                    FilmedRun recording(model, settings);
                    recording.run(force(820, {0.01, 0.02, 0.05}), 2).run({}, 5);
                    return recording;
                },
                integrator);
            EXPECT_LT(active, 0.95);
        }
    }
}

TEST(ActiveSlices, CostByWhatMovesNotByTheSizeOfTheTissue) {
    const auto activeNodes = [](int perSide) {
        const TissueModel model = tethered(membrane(perSide, stronglyDamped), 1);
        SimulationSettings settings = withStep(Integrator::Euler, shortStep);
        settings.restTolerance = restTolerance;
        FilmedRun recording(model, settings);
        recording.run(force(static_cast<std::uint32_t>(perSide / 2 * (perSide + 1)), {0.01, 0.02, 0.05}), 10);
        return recording.simulation().activeFraction() * static_cast<double>(model.mass.size());
    };
    EXPECT_LT(activeNodes(100), 2 * activeNodes(50));
}

TEST(ActiveSlices, TethersHereAndThereAreEnough) {
    const TissueModel model = tethered(tissue::fromMesh(tissue::sphereMesh(4, 0.05), stronglyDamped), 3);
    const double active = compare([&](const SimulationSettings& settings) {
        FilmedRun recording(model, settings);
        recording.run(force(7, {0.01, 0.02, 0.05}), 10).run({}, 30);
        return recording;
    });
    EXPECT_LT(active, 0.9);
}

TEST(ActiveSlices, AWaveTravelsToTheFarEndAndBack) {
    const TissueModel model = strip(300, {40, 1e-4, 1e-5});
    const double active = compare([&](const SimulationSettings& settings) {
        FilmedRun recording(model, settings);
        recording.run(force(599, {0.2, 0, 0}), 1, 10).run({}, 40);
        return recording;
    });
    EXPECT_LT(active, 1);
}

TEST(ActiveSlices, ALongSlowSwingGoesOn) {
    TissueModel model = membrane(30, {40, 0.001, 1e-5});
    for (std::uint32_t i = 0; i < 30; ++i)
        model.fixedNodes.push_back(i);
    compare([&](const SimulationSettings& settings) {
        FilmedRun recording(model, settings);
        recording.run(force(885, {0, 0.1, 0}), 2, 10).run({}, 75);
        return recording;
    });
}

TEST(ActiveSlices, GravityMovesWhatRested) {
    const TissueModel model = tethered(membrane(30, stronglyDamped), 2);
    Loads gravity;
    gravity.gravity = {0, 3, -9.81};
    const double active = compare([&](const SimulationSettings& settings) {
        FilmedRun recording(model, settings);
        recording.run(force(465, {0.01, 0.02, 0.05}), 40).run(gravity, 10);
        return recording;
    });
    EXPECT_LT(active, 0.9);
}

TEST(ActiveSlices, NewParametersMoveWhatRested) {
    const TissueModel model = tethered(membrane(30, stronglyDamped), 2);
    TissueModel softer = model;
    for (std::size_t i = 0; i < 450; ++i)
        softer.springConstant[i] /= 4;
    const double active = compare([&](const SimulationSettings& settings) {
        FilmedRun recording(model, settings);
        recording.run(force(465, {0.01, 0.02, 0.05}), 40);
        recording.simulation().setModel(softer);
        recording.run(force(465, {0.01, 0.02, 0.05}), 10);
        return recording;
    });
    EXPECT_LT(active, 0.9);
}

TEST(ActiveSlices, AnInstrumentMovesWhatRested) {
    const TriangleMesh mesh = tissue::gridMesh(20, 0.1);
    const TissueModel model = tethered(tissue::fromMesh(mesh, stronglyDamped), 2);
    const auto record = [&](const SimulationSettings& settings) {
        FilmedRun recording(model, settings, mesh.triangles);
        recording.run(force(90, {0.01, 0.02, 0.05}), 10).run({}, 30);
        Loads loads;
        for (double height = 0.03; height > 0.015; height -= 5e-4) {
            loads.instruments = {sphereAt({0.025, 0.025, height}, 0.02)};
            recording.run(loads, 1, 1);
        }
        loads.instruments.clear();
        return std::move(recording.run(loads, 5));
    };
    EXPECT_LT(compare(record), 0.9);
    FilmedRun recording = record(withStep(Integrator::Euler, shortStep));
    EXPECT_TRUE(wasTouched(recording.simulation()));
}

TEST(ActiveSlices, StepsOneByOneFollowTheMotionToo) {
    const TissueModel model = strip(100, {40, 1e-4, 1e-5});
    compare([&](const SimulationSettings& settings) {
        FilmedRun recording(model, settings);
        recording.run(force(199, {0.2, 0, 0}), 1, 10).run({}, 400, 1);
        return recording;
    });
}

TEST(ActiveSlices, DoNotDependOnTheThreads) {
    const TissueModel model = tethered(membrane(60, weaklyDamped), 1);
    for (const Precision precision : {Precision::Double, Precision::Float}) {
        SimulationSettings settings = withStep(Integrator::Heun, shortStep);
        settings.restTolerance = restTolerance;
        settings.precision = precision;
        const auto record = [&](std::size_t threads) {
            settings.threads = threads;
            FilmedRun recording(model, settings);
            recording.run(force(1830, {0.01, 0.02, 0.05}), 2);
            return recording;
        };
        EXPECT_TRUE(record(1).frames() == record(2).frames());
    }
}

// With these two a force spreads by one spring a step.
TEST(ActiveSlices, WhatDoesNotMoveAtAllIsLeftOutWithoutATrace) {
    const TissueModel model = tethered(membrane(60, stronglyDamped), 1);
    for (const Integrator integrator : {Integrator::Euler, Integrator::Verlet}) {
        const auto record = [&](double tolerance) {
            SimulationSettings settings = withStep(integrator, shortStep);
            settings.restTolerance = tolerance;
            FilmedRun recording(model, settings);
            recording.run(force(1830, {0.01, 0.02, 0.05}), 4, 4);
            return recording;
        };
        FilmedRun whole = record(0), part = record(1e-300);
        EXPECT_LT(part.simulation().activeFraction(), 1);
        EXPECT_TRUE(whole.frames() == part.frames()) << integratorName(integrator);
    }
}

TEST(ActiveSlices, WhatNothingHoldsNeverRests) {
    const TissueModel model = membrane(20, weaklyDamped);
    const double active = compare([&](const SimulationSettings& settings) {
        FilmedRun recording(model, settings);
        recording.run(force(210, {0.001, 0, 0}), 1).run({}, 20);
        return recording;
    });
    EXPECT_GT(active, 0.9);
}

TEST(ActiveSlices, CostNothingWhereEverythingRests) {
    SimulationSettings settings = withStep(Integrator::Euler, shortStep);
    settings.restTolerance = restTolerance;
    FilmedRun recording(tethered(membrane(20, weaklyDamped), 1), settings);
    recording.run({}, 10);
    EXPECT_LT(recording.simulation().activeFraction(), 0.01);
}
