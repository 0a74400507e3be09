#include "core/dynamics/measure/scene_run.h"
#include "core/samples/samples.h"
#include "tests/support/motion_difference.h"
#include "tests/support/sanitized.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace esm {
namespace {

using Vectors = std::vector<Eigen::Vector3d>;

Vectors afterwards(const TissueModel& model, const Scene& scene, const SimulationSettings& settings) {
    Vectors last;
    const SceneOutcome outcome =
        runScene({model, {}, scene, settings}, [&](double, const Vectors& positions) { last = positions; });
    EXPECT_TRUE(outcome.stable) << outcome.outcome;
    return last;
}

SimulationSettings stepping(Integrator integrator, double timeStep) {
    SimulationSettings settings;
    settings.integrator = integrator;
    settings.timeStep = timeStep;
    return settings;
}

/// The method's equations as they are written, with steps far below what they need: shares nothing with what
/// it is a witness for. Only for few springs, no tethers and forces that last from the start.
Vectors writtenOut(const TissueModel& model, const Scene& scene) {
    constexpr int steps = 200000;
    const double timeStep = scene.duration / steps;
    Vectors x = model.network->restPositions, v(x.size(), Eigen::Vector3d::Zero());
    for (int step = 0; step < steps; ++step) {
        Vectors force(x.size(), Eigen::Vector3d::Zero());
        for (const NodeForce& given : scene.forces)
            if (step * timeStep < given.to) force[given.node] += given.force;
        for (const Spring& spring : model.network->springs) {
            const auto [i, j, restLength] = spring;
            const double c = (model.springConstant[i] + model.springConstant[j]) / 2,
                         d = (model.viscosity[i] + model.viscosity[j]) / 2;
            const Eigen::Vector3d along = x[j] - x[i];
            const Eigen::Vector3d pull =
                c * (along.norm() - restLength) * along.normalized() + d * (v[j] - v[i]);
            force[i] += pull;
            force[j] -= pull;
        }
        for (std::size_t i = 0; i < x.size(); ++i) {
            if (std::binary_search(model.fixedNodes.begin(), model.fixedNodes.end(), i)) continue;
            v[i] += timeStep / model.mass[i] * force[i];
            x[i] += timeStep * v[i];
        }
    }
    return x;
}

TEST(PublishedUterus, MovesAsItsEquationsSay) {
    const Project uterus = makeSample("uterus");
    const TissueModel model = evaluateModel(uterus);
    for (const double duration : {0.1, 0.6, 1.5}) {
        Scene scene = uterus.scene;
        scene.duration = duration;
        const Vectors witness = writtenOut(model, scene);
        const auto errorOf = [&](const SimulationSettings& settings) {
            return motionDifference(afterwards(model, scene, settings), witness,
                                    model.network->restPositions);
        };
        EXPECT_LT(errorOf({}), 0.01) << duration << " s, chosen by the program";
        EXPECT_LT(errorOf(stepping(Integrator::Rk4, 1e-3)), 1e-3) << duration << " s";
        EXPECT_LT(errorOf(stepping(Integrator::Bdf2, 1e-3)), 1e-3) << duration << " s";
    }
}

// The tethers alone hold the tube: in the end they bear the whole force.
TEST(PublishedTube, RestsWhereItsTethersBearTheForce) {
    const Project tube = makeSample("tube");
    const TissueModel model = evaluateModel(tube);
    Scene scene = tube.scene;
    const Eigen::Vector3d force(0, 0.02, 0.05);
    scene.duration = 120;
    scene.forces = {{85, force, 0, scene.duration + 1}};
    scene.moves.clear();
    scene.instruments.clear();
    const Vectors positions = afterwards(model, scene, {});
    Eigen::Vector3d borne = Eigen::Vector3d::Zero();
    for (const Tether& tether : model.tethers)
        borne += tether.springConstant * (positions[tether.node] - model.network->restPositions[tether.node]);
    EXPECT_LT((borne - force).norm(), 1e-5 * force.norm());
    EXPECT_GT((positions[85] - model.network->restPositions[85]).norm(), 0.002);
}

// Two ways that share neither their splitting nor their matrix; the program's own choice beside them.
TEST(PublishedVentricle, MovesAlikeByUnlikeMethods) {
    const Project ventricle = makeSample("ventricle");
    const TissueModel model = evaluateModel(ventricle);
    Scene scene = ventricle.scene;
    scene.duration = isSanitized() ? 0.15 : 0.4;
    scene.instruments.clear();
    scene.forces = {{100, {0.3, 0.1, 0}, 0, 0.2}, {700, {0, -0.2, 0.2}, 0.1, 0.3}};
    const Vectors fine = afterwards(model, scene, stepping(Integrator::Bdf2, 2e-3));
    const auto errorOf = [&](const SimulationSettings& settings) {
        return motionDifference(afterwards(model, scene, settings), fine, model.network->restPositions);
    };
    EXPECT_LT(errorOf(stepping(Integrator::Split2, 2e-3)), 2e-3);
    EXPECT_LT(errorOf({}), 0.01);
}

} // namespace
} // namespace esm
