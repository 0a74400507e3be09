#include "core/dynamics/measure/energy_watch.h"

#include "core/dynamics/measure/scene_run.h"
#include "core/dynamics/stability/stability.h"
#include "core/samples/samples.h"
#include "tests/support/every_integrator.h"
#include "tests/support/rounds.h"
#include "tests/support/sanitized.h"
#include "tests/support/simulation_settings.h"
#include "tests/support/tissue_models.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace esm {
namespace {

TissueModel ballHeldBelow(const tissue::Parameters& parameters) {
    TissueModel model = tissue::fromMesh(tissue::sphereMesh(2, 0.05), parameters);
    for (std::uint32_t node = 0; node < model.mass.size(); ++node)
        if (model.network->restPositions[node].z() < -0.045) model.fixedNodes.push_back(node);
    return model;
}

std::uint32_t topOf(const TissueModel& model) {
    const auto& rest = model.network->restPositions;
    const auto top = std::max_element(rest.begin(), rest.end(),
                                      [](const auto& a, const auto& b) { return a.z() < b.z(); });
    return static_cast<std::uint32_t>(top - rest.begin());
}

class EnergyWatchByEach : public testing::TestWithParam<Integrator> {};
INSTANTIATE_TEST_SUITE_P(EnergyWatch, EnergyWatchByEach, testing::ValuesIn(allIntegrators),
                         nameOfIntegratorTest);

/// A millionth of a newton for one step, then many more.
SceneOutcome pushed(const TissueModel& model, Integrator integrator, double timeStep) {
    Scene scene;
    scene.duration = 3000 * timeStep;
    scene.forces = {{topOf(model), {3e-7, 5e-7, -8e-7}, 0, timeStep}};
    scene.record.every = scene.duration;
    return runScene({model, {}, scene, withStep(integrator, timeStep)}, {});
}

TEST_P(EnergyWatchByEach, TellsStepsThatAreALittleTooLong) {
    for (const double viscosity : {0.002, 0.02}) {
        const TissueModel model = ballHeldBelow({50, viscosity, 0.0001});
        const auto limit = criticalStep(model, GetParam(), {1e-3, Deformation::AtRest, {}});
        // What solves for velocities of all has no limit; propagation's is not one of stability.
        if (!limit || std::isinf(*limit) || GetParam() == Integrator::Propagation) continue;
        EXPECT_TRUE(pushed(model, GetParam(), 0.97 * *limit).stable) << viscosity;
        // The bounds of these are of a larger set than the tissue's own motions, or growth is slow beyond
        // them.
        const bool isSlow = GetParam() == Integrator::Split2 || GetParam() == Integrator::Heun;
        const double beyond = isSlow ? 1.3 : 1.05;
        const SceneOutcome outcome = pushed(model, GetParam(), beyond * *limit);
        EXPECT_FALSE(outcome.stable) << viscosity << ": " << outcome.outcome;
    }
}

/// Forces, led nodes, gravity and an instrument, drawn by lot.
Scene drawnScene(const TissueModel& model, std::mt19937& dice) {
    const auto between = [&](double low, double high) {
        return low + (high - low) * static_cast<double>(dice()) / static_cast<double>(std::mt19937::max());
    };
    const auto vector = [&](double length) {
        return Eigen::Vector3d(between(-length, length), between(-length, length), between(-length, length));
    };
    Scene scene;
    scene.duration = 0.3;
    const std::uint32_t top = topOf(model);
    if (dice() % 2 == 0) scene.gravity = vector(10);
    for (int i = 0; i < 3; ++i)
        scene.forces.push_back({(top + 17U * static_cast<std::uint32_t>(i)) % 100, vector(0.3),
                                between(0, 0.2), between(0.2, 0.3)});
    if (dice() % 2 == 0) {
        Path path{{0, {0, 0, 0}}};
        for (int i = 1; i < 8; ++i)
            path.push_back({0.03 * i + between(0, 0.02), vector(0.01)});
        scene.moves = {{top, path}};
    } else {
        scene.instruments = {
            {Sphere{0.01}, {{0, {0, 0, 0.07}}, {0.15, vector(0.03)}, {0.3, vector(0.07)}}, {}, {}}};
    }
    return scene;
}

TEST_P(EnergyWatchByEach, RaisesNoAlarmInStableRuns) {
    std::mt19937 dice(3);
    const TriangleMesh mesh = tissue::sphereMesh(2, 0.05);
    std::vector<tissue::Parameters> tried{{50, 0.02, 0.0001}, {10, 0.5, 0.0002}, {200, 0.001, 0.001}};
    if (isSanitized()) tried.resize(1);
    for (const tissue::Parameters& parameters : tried) {
        TissueModel model = ballHeldBelow(parameters);
        const auto limit = criticalStep(model, GetParam());
        if (!limit) continue;
        for (int i = isSanitized() ? 3 : 0; i < 4; ++i) {
            if (i == 3) model.stiffening = SpringStiffening{0.1, 2};
            const double longest = i == 3 ? *criticalStep(model, GetParam()) : *limit;
            const double margin = GetParam() == Integrator::Propagation ? 0.25 : 0.95; // where it settles
            const double step = std::min(margin * longest, 0.005) / (1 + i % 2);
            const Scene scene = drawnScene(model, dice);
            const SceneOutcome outcome =
                runScene({model, mesh.triangles, scene, withStep(GetParam(), step)}, {});
            EXPECT_TRUE(outcome.stable)
                << outcome.outcome << ", scene " << i << ", " << parameters.springConstant;
        }
    }
}

/// As many as take about as long by any integrator.
int stepsToWatch(Integrator integrator) {
    if (isSanitized()) return 10;
    if (isExplicit(integrator)) return roundsOf(300, 5000);
    return integrator == Integrator::Propagation ? roundsOf(8, 500) : roundsOf(40, 500);
}

// With what holds and moves them.
TEST_P(EnergyWatchByEach, RaisesNoAlarmOnTheProgramsOrgans) {
    for (const std::string organ : {"tube", "ventricle", "liver"}) {
        if (isSanitized() && organ != "tube") continue; // more of the same steps
        const Project project = makeSample(organ);
        const TissueModel model = evaluateModel(project);
        const auto limit = criticalStep(model, GetParam());
        if (!limit) continue;
        const double margin = GetParam() == Integrator::Propagation ? 0.25 : 0.95; // where it settles
        const double step = std::min(margin * *limit, 0.005);
        Scene scene = project.scene;
        scene.duration = std::min(scene.duration, stepsToWatch(GetParam()) * step);
        scene.forces = {
            {static_cast<std::uint32_t>(model.mass.size() / 2), {0, 0.05, 0}, 0, scene.duration / 2}};
        scene.record.every = scene.duration;
        const TouchedSurface surface = touchedSurface(*project.mesh, *project.network);
        const SceneOutcome outcome = runScene({model, surface, scene, withStep(GetParam(), step)}, {});
        EXPECT_TRUE(outcome.stable) << organ << ": " << outcome.outcome;
    }
}

// As a package holds them: what swings then comes of no load.
TEST_P(EnergyWatchByEach, RaisesNoAlarmWhereRestLengthsWereRounded) {
    TissueModel model = ballHeldBelow({100, 0, 0.0001});
    SpringNetwork rounded = *model.network;
    for (Spring& spring : rounded.springs)
        spring.restLength = static_cast<float>(spring.restLength);
    model.network = std::make_shared<const SpringNetwork>(rounded);
    const auto limit = criticalStep(model, GetParam());
    if (!limit) return;                                                        // without viscosity
    const double margin = GetParam() == Integrator::Propagation ? 0.25 : 0.95; // where it settles
    const double step = std::min(margin * *limit, 0.005);
    Scene scene;
    scene.duration = 10 * stepsToWatch(GetParam()) * step;
    scene.record.every = scene.duration;
    const SceneOutcome outcome = runScene({model, {}, scene, withStep(GetParam(), step)}, {});
    EXPECT_TRUE(outcome.stable) << outcome.outcome;
}

TEST(EnergyWatch, RaisesNoAlarmOverRoundingInSinglePrecision) {
    const TissueModel model = ballHeldBelow({50, 0.02, 0.0001});
    SimulationSettings settings;
    settings.integrator = Integrator::Euler;
    settings.precision = Precision::Float;
    Scene scene;
    scene.forces = {{topOf(model), {0, 0, 1e-9}, 0, 0.001}};
    const SceneOutcome outcome = runScene({model, {}, scene, settings}, {});
    EXPECT_TRUE(outcome.stable) << outcome.outcome;
}

} // namespace
} // namespace esm
