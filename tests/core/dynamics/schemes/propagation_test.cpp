#include "core/dynamics/forces.h"
#include "core/dynamics/schemes/propagation.h"
#include "core/support/errors.h"
#include "tests/support/tissue_models.h"

#include <gmock/gmock.h>

using namespace esm;
using tissue::Vectors;

namespace {

struct Pulled {
    TissueModel model = tissue::fromMesh(tissue::gridMesh(9, 0.1), {10, 0.05, 0.001});
    SpringSystem system;
    Loads loads;
    Motion before;

    Pulled() {
        model.fixedNodes = {0, 8};
        model.tethers = {{70, 3, 0.2}};
        system = makeSpringSystem(model);
        loads.gravity = {0, 0, -9.81};
        loads.forces = {{40, {0.1, 0.05, 0.2}}};
        before = {model.network->restPositions, Vectors(81, Eigen::Vector3d::Zero())};
    }
};

/// Propagation needs no matrices: none are made.
Motion stepped(PropagationScheme scheme, const SpringSystem& system, const StepInput& input,
               const Motion& before) {
    StepperSolvers none(system, Integrator::Propagation,
                        StepSolvers(system.fixed, std::make_shared<MatrixFactoriser>()));
    return scheme.step(system, input, before, none).motion;
}

} // namespace

// What settles is the step of implicit Euler, its forces taken where it ends: M·(v⁺ − v) = h·(f(x⁺) − D·v⁺ +
// g).
TEST(Propagation, SettlesInTheImplicitStep) {
    for (const Damping damping : {Damping::Isotropic, Damping::Axial}) {
        const Pulled pulled;
        const double h = 0.02;
        const Motion after = stepped(PropagationScheme(pulled.system, damping), pulled.system,
                                     {h, &pulled.loads, {{30, pulled.before.positions[30]}}}, pulled.before);
        Vectors forces;
        elasticForces(pulled.system, after.positions, forces);
        addDampingForces(pulled.system, damping, after.positions, after.velocities, forces);
        addExternalForces(pulled.system, pulled.loads, forces);
        EXPECT_GT((after.positions[40] - pulled.before.positions[40]).norm(), 1e-3);
        for (std::size_t i = 0; i < forces.size(); ++i) {
            if (i == 0 || i == 8 || i == 30) {
                EXPECT_EQ(after.positions[i], pulled.before.positions[i]);
                continue;
            }
            const Eigen::Vector3d asked = pulled.before.velocities[i] + h / 0.001 * forces[i];
            EXPECT_LT((after.velocities[i] - asked).norm(), 1e-7) << i;
            EXPECT_LT((after.positions[i] - pulled.before.positions[i] - h * after.velocities[i]).norm(),
                      1e-15);
        }
    }
}

TEST(Propagation, SaysWhenForcesDoNotSettle) {
    TissueModel model = tissue::fromMesh(tissue::gridMesh(9, 0.1), {1e6, 1e6, 1e-9});
    const SpringSystem system = makeSpringSystem(model);
    Loads loads;
    loads.forces = {{40, {0, 0, 1}}};
    EXPECT_THROW(stepped(PropagationScheme(system, Damping::Isotropic), system, {1, &loads, {}},
                         {model.network->restPositions, Vectors(81, Eigen::Vector3d::Zero())}),
                 InvalidModel);
}

TEST(Propagation, CanBeCancelledWithinAStep) {
    const SpringSystem system =
        makeSpringSystem(tissue::fromMesh(tissue::gridMesh(9, 0.1), {1e6, 1e6, 1e-9}));
    Loads loads;
    loads.forces = {{40, {0, 0, 1}}};
    int asked = 0;
    const PropagationScheme scheme(system, Damping::Isotropic, [&asked] { return ++asked < 3; });
    EXPECT_THROW(stepped(scheme, system, {1, &loads, {}},
                         {system.network->restPositions, Vectors(81, Eigen::Vector3d::Zero())}),
                 Cancelled);
    EXPECT_EQ(asked, 3);
}

// What every scheme does that has no quicker way to step many times.
TEST(Propagation, TakesManyStepsOneAfterTheOther) {
    const Pulled pulled;
    PropagationScheme scheme(pulled.system, Damping::Isotropic);
    StepperSolvers none(pulled.system, Integrator::Propagation,
                        StepSolvers(pulled.system.fixed, std::make_shared<MatrixFactoriser>()));
    Motion together = pulled.before, single = pulled.before;
    const StepInput input{0.02, &pulled.loads, {}};
    scheme.steps(pulled.system, input, 3, together, none);
    for (int i = 0; i < 3; ++i)
        single = scheme.step(pulled.system, input, single, none).motion;
    EXPECT_EQ(together.positions, single.positions);
    EXPECT_EQ(together.velocities, single.velocities);
    EXPECT_NE(together.positions, pulled.before.positions);
}
