#include "core/dynamics/schemes/axial_dampers.h"

#include "core/dynamics/forces.h"
#include "core/dynamics/measure/scene_run.h"
#include "tests/support/reference_motion.h"
#include "tests/support/simulation_settings.h"
#include "tests/support/tissue_models.h"

#include <gtest/gtest.h>

namespace esm {
namespace {

/// Of an oblique spring whose second node goes along, and turns it at the same time.
struct TurningSpring {
    SpringSystem system = makeSpringSystem(tissue::oneSpring({10, 0.3, 0.001}));

    static Vectors at(double time) {
        const double angle = 3 * time + 20 * time * time, length = 1.1 + 2 * time - 5 * time * time;
        return {{0, 0, 0}, {length * std::cos(angle), length * std::sin(angle), 0}};
    }
    Eigen::Vector3d force(const LengthChange& change, double time) const {
        Vectors elastic, all;
        elasticForces(system, at(time), elastic);
        elasticForces(withAxialDampers(system, change), at(time), all);
        return all[0] - elastic[0];
    }
    /// d times the rate at which the spring lengthens, along it.
    Eigen::Vector3d exactForce(double time) const { return 0.3 * (2 - 10 * time) * at(time)[1].normalized(); }
};

TEST(AxialDampers, PullByTheRateOfTheLengthAlongTheDirectionAtTheEnd) {
    const TurningSpring spring;
    for (const double h : {1e-2, 1e-3}) {
        const LengthChange change = changeFrom(spring.system, spring.at(0.1 - h), h);
        EXPECT_LT((spring.force(change, 0.1) - spring.exactForce(0.1)).norm(), 0.3 * 6 * h) << h;
    }
}

TEST(AxialDampers, OverTwoStepsPullByTheExactRateOfAQuadraticWay) {
    const TurningSpring spring;
    const double h = 0.01;
    const LengthChange change = changeFrom(spring.system, spring.at(0.1 - h), spring.at(0.1 - 2 * h), h);
    EXPECT_LT((spring.force(change, 0.1) - spring.exactForce(0.1)).norm(), 1e-12);
}

TEST(AxialDampers, TakeThePlaceOfTheSpringsViscosityButNotOfTheTethers) {
    TissueModel model = tissue::oneSpring({10, 0.3, 0.001});
    model.tethers = {{0, 5, 0.7}};
    const SpringSystem system = makeSpringSystem(model);
    const SpringSystem damped = withAxialDampers(system, changeFrom(system, TurningSpring::at(0), 0.01));
    for (const auto& element : damped.springs)
        EXPECT_EQ(element.viscosity, 0);
    EXPECT_EQ(damped.tethers.front().viscosity, 0.7);
}

/// Of the published tube that a force draws aside, relative to the motion.
double errorOfPulledTube(Integrator integrator, double step) {
    const TissueModel tube = tissue::fallopianTube();
    Scene scene;
    scene.duration = 0.02;
    scene.forces = {{85, {0, 0, 0.1}, 0, 1}};
    scene.record.every = 0.004;
    SimulationSettings settings = withStep(integrator, step);
    settings.damping = Damping::Axial;
    std::vector<double> times;
    std::vector<Vectors> frames;
    runScene({tube, {}, scene, settings}, [&](double time, const Vectors& places) {
        times.push_back(time);
        frames.push_back(places);
    });
    const auto exact = reference::placesAt({tube, scene, Damping::Axial}, times, 1e-8);
    return reference::relativeDifference(frames, exact, tube.network->restPositions);
}

// The tube's viscosity along its springs is heavy, across them there is none: its springs turn, and whatever
// holds on to their old directions within a step stretches them instead.
TEST(AxialDampers, LetImplicitStepsFollowTissueThatTurns) {
    EXPECT_LT(errorOfPulledTube(Integrator::Bdf2, 4e-4), 0.05);
    EXPECT_LT(errorOfPulledTube(Integrator::Bdf2, 1e-4), 0.01);
    EXPECT_LT(errorOfPulledTube(Integrator::Implicit, 1e-3), 0.15);
}

TEST(AxialDampers, LeaveItsOrderToBdf2) {
    EXPECT_LT(errorOfPulledTube(Integrator::Bdf2, 1e-4), 0.3 * errorOfPulledTube(Integrator::Bdf2, 2e-4));
}

} // namespace
} // namespace esm
