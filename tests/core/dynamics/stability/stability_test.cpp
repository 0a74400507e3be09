#include "core/dynamics/schemes/split2.h"
#include "core/dynamics/stability/stability.h"
#include "core/dynamics/stability/swings.h"
#include "core/support/errors.h"
#include "tests/support/sanitized.h"
#include "tests/support/simulation_settings.h"
#include "tests/support/tissue_models.h"

#include <Eigen/Eigenvalues>
#include <gmock/gmock.h>

#include <array>

using namespace esm;

namespace {

/// Largest growth factor of an oscillator with stepDamping = h·d/m and stepStiffness = (hω)² under split2,
/// from the matrix that takes (x, x⁻, h·v, h·v⁻) to the next step.
double split2Growth(double stepDamping, double stepStiffness) {
    const double a = 1.5 + stepDamping, k = stepStiffness;
    Eigen::Matrix4d next;
    const Eigen::RowVector4d velocity(-2 * k / a, k / a, 2 / a, -0.5 / a);
    next << (4.0 / 3) + 2.0 / 3 * velocity[0], -1.0 / 3 + 2.0 / 3 * velocity[1], 2.0 / 3 * velocity[2],
        2.0 / 3 * velocity[3], 1, 0, 0, 0, velocity, 0, 0, 1, 0;
    return next.eigenvalues().cwiseAbs().maxCoeff();
}

TEST(Split2Limit, IsWhereARootLeavesTheUnitCircle) {
    for (const double damping : {1e-4, 1e-2, 0.1, 0.3866, 0.7, 1.1, 8.0 / 7, 1.3, 3.0, 50.0, 1e4}) {
        const double limit = split2Limit(damping);
        EXPECT_GT(split2Growth(damping, 1.001 * limit), 1) << damping;
        for (const double part : {1e-3, 0.1, 0.5, 0.9, 0.999}) {
            EXPECT_LE(split2Growth(damping, part * limit), 1 + 1e-12) << damping;
        }
    }
    // The rules that are known: a half plane for strong damping, h³ω⁴ < 2d/m for weak.
    EXPECT_DOUBLE_EQ(split2Limit(6), 16.0 / 3 + 8);
    EXPECT_NEAR(split2Limit(1e-8), std::sqrt(2e-8), 1e-7);
    EXPECT_EQ(split2Limit(0), 0);
}

/// Whether the energy of a small kick everywhere grows a millionfold. Near its limit a weakly damped split2
/// grows by little at each of very many steps.
bool blowsUp(const TissueModel& model, Integrator integrator, double step) {
    Simulation simulation(model, withStep(integrator, step));
    Loads kick;
    for (std::uint32_t i = 0; i < model.mass.size(); ++i)
        kick.forces.emplace_back(
            i, 1e-6 * model.mass[i] / step *
                   Eigen::Vector3d(std::sin(9.1 * i), std::cos(5.3 * i), std::sin(3.7 * i + 1)));
    const auto total = [&] { return simulation.energy().kinetic + simulation.energy().elastic; };
    EXPECT_TRUE(simulation.step(kick));
    const double given = total();
    constexpr std::size_t together = 100;
    for (int i = 0; i < 400; ++i)
        if (simulation.advance({}, together) < together || total() > 1e6 * given) return true;
    return false;
}

/// A chain along x, where the weighted Laplacian is the stiffness itself, moved lengthwise.
TissueModel chain(const tissue::Parameters& parameters) {
    SpringNetwork network;
    for (int i = 0; i < 20; ++i)
        network.restPositions.emplace_back(1000 * i, 0, 0);
    for (std::size_t i = 0; i + 1 < 20; ++i)
        tissue::addSpring(network, i, i + 1);
    return tissue::model(std::move(network), parameters);
}

std::vector<double> chainViscosities() {
    if (isSanitized()) return {0.2};
    return {0.03, 0.2, 2, 50};
}

TEST(CriticalSteps, AreWhereUniformTissueBlowsUp) {
    for (const double viscosity : chainViscosities()) {
        const tissue::Parameters parameters{100, viscosity, 0.01};
        const TissueModel model = chain(parameters);
        const CriticalSteps steps = criticalSteps(model);
        for (const auto& [integrator, step] : steps) {
            SCOPED_TRACE(std::string(integratorName(integrator)) + ", viscosity " +
                         std::to_string(parameters.viscosity));
            ASSERT_TRUE(step);
            // That of the propagation bounds how long its forces take to settle.
            if (std::isinf(*step) || integrator == Integrator::Propagation) continue;
            EXPECT_FALSE(blowsUp(model, integrator, 0.95 * *step)) << *step;
            EXPECT_TRUE(blowsUp(model, integrator, 1.05 * *step)) << *step;
        }
    }
}

TEST(CriticalSteps, HoldWhereElasticityAndViscosityDoNotCommute) {
    TissueModel model = tissue::fromMesh(tissue::gridMesh(8, 0.1), {50, 0.5, 0.001});
    for (std::size_t i = 0; i < model.mass.size(); ++i) {
        model.springConstant[i] *= std::exp(2 * std::sin(1.7 * static_cast<double>(i)));
        model.viscosity[i] *= std::exp(2 * std::cos(2.9 * static_cast<double>(i)));
        model.mass[i] *= std::exp(std::sin(4.1 * static_cast<double>(i)));
    }
    model.tethers = {{3, 500, 0.01}, {40, 1, 30}};
    const CriticalSteps steps = criticalSteps(model);
    EXPECT_FALSE(blowsUp(model, Integrator::Euler, 0.99 * *steps.at(Integrator::Euler)));
    EXPECT_FALSE(blowsUp(model, Integrator::Split, 0.99 * *steps.at(Integrator::Split)));
    EXPECT_FALSE(blowsUp(model, Integrator::Split2, 0.99 * *steps.at(Integrator::Split2)));
    // Rest shape and direction matter only a little: the bound is not needlessly short either.
    EXPECT_TRUE(blowsUp(model, Integrator::Euler, 2 * *steps.at(Integrator::Euler)));
    EXPECT_TRUE(blowsUp(model, Integrator::Split, 2 * *steps.at(Integrator::Split)));
}

TEST(CriticalSteps, OfUnevenOverdampedTissueThatNothingHoldsFollowTheHalfPlane) {
    TissueModel model = tissue::fromMesh(tissue::gridMesh(8, 0.1), {50, 50, 0.001});
    for (std::size_t i = 0; i < model.mass.size(); ++i)
        model.springConstant[i] *= std::exp(std::sin(1.7 * static_cast<double>(i)));
    const double step = *criticalStep(model, Integrator::Split2);
    EXPECT_FALSE(blowsUp(model, Integrator::Split2, 0.99 * step));
    EXPECT_TRUE(blowsUp(model, Integrator::Split2, 1.5 * step));
    EXPECT_NEAR(step, 2.0 / 3 * *criticalStep(model, Integrator::Split), 0.01 * step);
}

TEST(CriticalSteps, KnowWhereThereIsNoLimitAndNoStep) {
    EXPECT_EQ(criticalSteps(tissue::oneSpring({0, 0, 1})).at(Integrator::Euler),
              std::numeric_limits<double>::infinity());
    EXPECT_EQ(criticalSteps(tissue::oneSpring({0, 1, 1})).at(Integrator::Split2),
              std::numeric_limits<double>::infinity());
    TissueModel fixed = tissue::oneSpring({10, 1, 1});
    fixed.fixedNodes = {0, 1};
    EXPECT_EQ(criticalSteps(fixed).at(Integrator::Split), std::numeric_limits<double>::infinity());
    const CriticalSteps undamped = criticalSteps(tissue::oneSpring({10, 0, 1}));
    EXPECT_EQ(undamped.at(Integrator::Split2), std::nullopt);
    EXPECT_NEAR(*undamped.at(Integrator::Euler), 2 / std::sqrt(20), 1e-3);
    EXPECT_NEAR(*undamped.at(Integrator::Split), 2 / std::sqrt(20), 1e-3);
}

TEST(CriticalSteps, OfBiphasicSpringsAreThoseOfTheStifferBranch) {
    TissueModel model = tissue::oneSpring({10, 0, 1});
    model.stiffening = SpringStiffening{0.2, 9};
    EXPECT_NEAR(*criticalStep(model, Integrator::Euler), 2 / std::sqrt(20 * 9), 1e-3);
    EXPECT_NEAR(*criticalStep(model, Integrator::Euler, {1e-3, Deformation::AtRest, {}}), 2 / std::sqrt(20),
                1e-3);
    model.stiffening->factor = 0.1;
    EXPECT_NEAR(*criticalStep(model, Integrator::Euler), 2 / std::sqrt(20), 1e-3);
}

TEST(CriticalSteps, OfThePublishedTubeAllowEulerMicrosecondsAndTheSplitFormsTenthsOfASecond) {
    const TissueModel tube = tissue::fallopianTube();
    const CriticalSteps steps = criticalSteps(tube);
    EXPECT_FALSE(blowsUp(tube, Integrator::Euler, 0.95 * *steps.at(Integrator::Euler)));
    EXPECT_TRUE(blowsUp(tube, Integrator::Euler, 1.05 * *steps.at(Integrator::Euler)));
    EXPECT_LT(*steps.at(Integrator::Euler), 5e-6);
    EXPECT_GT(*steps.at(Integrator::Split), 0.3);
    EXPECT_GT(*steps.at(Integrator::Split2), 0.2);
}

TEST(IsStable, HoldsUpToTheLimitWhateverItIs) {
    const TissueModel tube = tissue::fallopianTube();
    for (const Integrator integrator : {Integrator::Euler, Integrator::Rk4, Integrator::Split2}) {
        const double limit = *criticalStep(tube, integrator);
        EXPECT_TRUE(isStable(tube, {integrator, 0.95 * limit})) << integratorName(integrator);
        EXPECT_FALSE(isStable(tube, {integrator, 1.05 * limit})) << integratorName(integrator);
    }
    EXPECT_TRUE(isStable(tube, {Integrator::Bdf2, 100}));
}

TEST(CriticalStep, IsFoundCoarselyOnTheSafeSide) {
    TissueModel model = tissue::fromMesh(tissue::gridMesh(8, 0.1), {50, 0.5, 0.001});
    for (std::size_t i = 0; i < model.mass.size(); ++i)
        model.viscosity[i] *= std::exp(2 * std::cos(2.9 * static_cast<double>(i)));
    const CriticalSteps exact = criticalSteps(model);
    for (const auto& [integrator, step] : {std::pair{Integrator::Euler, exact.at(Integrator::Euler)},
                                           {Integrator::Split, exact.at(Integrator::Split)},
                                           {Integrator::Split2, exact.at(Integrator::Split2)}}) {
        int fineCalls = 0, coarseCalls = 0;
        const auto counting = [](int& calls) {
            return [&calls](double fraction) {
                EXPECT_TRUE(fraction >= 0 && fraction <= 1);
                ++calls;
                return true;
            };
        };
        EXPECT_EQ(criticalStep(model, integrator, {1e-3, Deformation::Any, counting(fineCalls)}), step);
        const double coarse =
            *criticalStep(model, integrator, {0.05, Deformation::Any, counting(coarseCalls)});
        EXPECT_LE(coarse, 1.0011 * *step);
        EXPECT_GT(coarse, 0.949 * *step);
        EXPECT_LE(coarseCalls, fineCalls);
    }
}

TEST(ChooseStep, TakesElasticityImplicitlyWhereOtherStepsFallBehindRealTime) {
    const TissueModel model = tissue::fromMesh(tissue::sphereMesh(4, 0.05), {1e5, 3, 6e-4});
    EXPECT_EQ(chooseStep(model, {}).integrator, Integrator::Bdf2);
    EXPECT_EQ(chooseStep(model, {}).timeStep, longestStep);
}

TEST(ChooseStep, TakesTheStiffestTissueInStepsThatCanBeSolvedFor) {
    const TissueModel model = tissue::fromMesh(tissue::sphereMesh(3, 0.05), {1e9, 1e-6, 1e-9});
    for (const Damping damping : {Damping::Isotropic, Damping::Axial}) {
        SimulationSettings settings;
        settings.damping = damping;
        const ChosenStep solvable = chooseStep(model, settings);
        EXPECT_EQ(solvable.integrator, Integrator::Bdf2) << "explicit steps are too short to compute with";
        EXPECT_LT(solvable.timeStep, longestStep);
        settings.timeStep = solvable.timeStep;
        EXPECT_TRUE(Simulation(model, settings).step({}));
    }
}

TEST(ChooseStep, NeverTakesWhatLagsWhereTissueTurns) {
    for (const double springConstant : {1e2, 1e5, 1e9})
        for (const double mass : {1e-9, 1e-3}) {
            const TissueModel model =
                tissue::fromMesh(tissue::sphereMesh(3, 0.05), {springConstant, 1e-6, mass});
            for (const std::optional<double> step : {std::optional<double>(), {0.02}, {10.0}}) {
                SimulationSettings settings;
                settings.timeStep = step;
                EXPECT_FALSE(traitsOf(chooseStep(model, settings).integrator).lagsWhereTissueTurns);
            }
        }
}

TEST(ChooseStep, TakesNothingDearerWhereNothingKeepsUp) {
    if (isSanitized()) GTEST_SKIP() << "too many nodes for the sanitizers";
    const TissueModel model = tissue::fromMesh(tissue::gridMesh(220, 0.3), {16.26, 2.877, 1e-4});
    const ChosenStep chosen = chooseStep(model, {});
    EXPECT_EQ(chosen.integrator, Integrator::Split2);
    EXPECT_EQ(chosen.timeStep, longestStep);
}

TEST(ChooseStep, TakesStepsThatAreSolvedForHoweverStiffTheTissueIs) {
    for (const double springConstant : {1e6, 1e9})
        for (const double viscosity : {0.0, 3.0, 1e6}) {
            SCOPED_TRACE(std::to_string(springConstant) + " N/m, " + std::to_string(viscosity) + " N·s/m");
            Simulation simulation(
                tissue::fromMesh(tissue::sphereMesh(3, 0.05), {springConstant, viscosity, 6e-4}), {});
            Loads loads;
            loads.forces = {{7, {0.3, 0.2, -1}}};
            loads.prescribed = {{100, simulation.positions()[100] + Eigen::Vector3d(0, 0.004, 0.002)}};
            for (int i = 0; i < 10; ++i)
                EXPECT_TRUE(simulation.step(loads)) << simulation.failure();
        }
}

TEST(CriticalStep, StopsWhenAsked) {
    const TissueModel model = tissue::fromMesh(tissue::gridMesh(8, 0.1), {50, 0.5, 0.001});
    EXPECT_THROW(
        criticalStep(model, Integrator::Euler, {0.05, Deformation::Any, [](double) { return false; }}),
        Cancelled);
}

TEST(ChooseStep, TakesTheOverdampedTissueByItsSecondOrderForm) {
    const ChosenStep chosen = chooseStep(tissue::fallopianTube(), {});
    EXPECT_EQ(chosen.integrator, Integrator::Split2);
    EXPECT_EQ(chosen.timeStep, 0.01);
}

TEST(ChooseStep, TakesUndampedTissueByEuler) {
    const ChosenStep chosen = chooseStep(tissue::fromMesh(tissue::gridMesh(8, 0.1), {1e4, 0, 0.001}), {});
    EXPECT_EQ(chosen.integrator, Integrator::Euler);
    EXPECT_LT(chosen.timeStep, 0.01);
}

TEST(ChooseStep, TakesAGivenStepAsGiven) {
    const TissueModel tube = tissue::fallopianTube();
    EXPECT_EQ(chooseStep(tube, withStep(Integrator::Euler, 0.02)).timeStep, 0.02);
    EXPECT_EQ(chooseStep(tube, withStep(Integrator::Auto, 0.02)).integrator, Integrator::Split2);
    EXPECT_EQ(chooseStep(tube, withStep(Integrator::Auto, 10)).integrator, Integrator::Bdf2);
    EXPECT_EQ(chooseStep(tube, withStep(Integrator::Auto, 1e4)).integrator, Integrator::Bdf2);
    SimulationSettings axial = withStep(Integrator::Auto, 0.02);
    axial.damping = Damping::Axial;
    EXPECT_EQ(chooseStep(tube, axial).integrator, Integrator::Bdf2);
    axial.timeStep = 1e-7;
    EXPECT_EQ(chooseStep(tube, axial).integrator, Integrator::Euler);
}

TEST(ChooseStep, SaysWhyNoStepIsStable) {
    const TissueModel damped = tissue::oneSpring({10, 0.1, 1});
    SimulationSettings settings;
    settings.integrator = Integrator::Heun;
    EXPECT_GT(chooseStep(damped, settings).timeStep, 0);
    settings.damping = Damping::Axial;
    try {
        chooseStep(damped, settings);
        FAIL() << "accepted";
    } catch (const InvalidModel& problem) {
        EXPECT_THAT(problem.what(), testing::HasSubstr("isotropic damping"));
    }
}

TEST(ChooseStep, RefusesWhatCannotWork) {
    const TissueModel model = tissue::oneSpring({10, 0, 1});
    SimulationSettings settings = withStep(Integrator::Split2, 0);
    settings.damping = Damping::Axial;
    try {
        chooseStep(model, settings);
        FAIL() << "accepted";
    } catch (const InvalidModel& problem) {
        EXPECT_EQ(problem.problems().size(), 2);
    }
    settings = {};
    settings.integrator = Integrator::Split2;
    EXPECT_THROW(chooseStep(model, settings), InvalidModel);
    TissueModel broken = model;
    broken.mass[0] = 0;
    EXPECT_THROW(chooseStep(broken, {}), InvalidModel);
    EXPECT_THROW(Simulation(broken, {}), InvalidModel);
}

} // namespace
