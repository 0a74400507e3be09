#include "core/dynamics/measure/extremes.h"
#include "core/dynamics/simulation.h"
#include "core/dynamics/stability/stability.h"
#include "core/support/errors.h"
#include "tests/support/every_integrator.h"
#include "tests/support/rounds.h"
#include "tests/support/sanitized.h"
#include "tests/support/tissue_models.h"

#include <gmock/gmock.h>

using namespace esm;

namespace {

struct Sweep {
    std::vector<double> springConstants, viscosities, masses;
    int steps;             ///< each
    std::size_t everyCase; ///< of the program's own cases
};

Sweep sweep() {
    if (isSanitized()) return {{1e-6, 1e9}, {0, 1, 1e6}, {1e-9, 1e3}, 20, 19}; // the outermost corners
    // Every seventh meets every value of every parameter.
    return {{1e-6, 1, 1e4, 1e9},
            {0, 1e-6, 1, 1e3, 1e6},
            {1e-9, 1e-3, 1e3},
            roundsOf(200, 2000),
            isLongRun() ? std::size_t{1} : std::size_t{7}};
}

// Every corner of what sliders and files can ask for: a run stays whole or is refused with a reason.
TEST(Extremes, StayWholeOrAreRefused) {
    const TriangleMesh mesh = tissue::sphereMesh(1, 0.05);
    const Sweep tried = sweep();
    int ran = 0, refused = 0;
    for (const double springConstant : tried.springConstants)
        for (const double viscosity : tried.viscosities)
            for (const double mass : tried.masses)
                for (const bool contrast : {false, true})
                    for (const bool tied : {false, true}) {
                        TissueModel model = tissue::fromMesh(mesh, {springConstant, viscosity, mass});
                        if (contrast)
                            for (std::size_t i = 0; i < 20; ++i) {
                                model.springConstant[i] *= 1e-6;
                                model.viscosity[2 * i] *= 1e-6;
                            }
                        if (tied) model.fixedNodes = {0, 1, 2};
                        SCOPED_TRACE(testing::Message() << springConstant << " " << viscosity << " " << mass
                                                        << " " << contrast << tied);
                        try {
                            Simulation simulation(model, {}, mesh.triangles);
                            // What is tied to nothing drags its softest part behind it.
                            const double softest =
                                *std::min_element(model.springConstant.begin(), model.springConstant.end());
                            Loads loads;
                            loads.forces = {{30, {0, 0, 0.01 * (tied ? springConstant : softest)}}};
                            for (int i = 0; i < tried.steps; ++i) {
                                if (i == tried.steps / 2) loads = Loads{};
                                ASSERT_TRUE(simulation.step(loads)) << simulation.failure();
                            }
                            ++ran;
                        } catch (const InvalidModel& reason) {
                            EXPECT_FALSE(reason.problems().empty());
                            ++refused;
                        }
                    }
    EXPECT_GE(ran, 5 * refused) << ran << " ran, " << refused << " refused";
}

std::vector<Integrator> integratorsAndAuto() {
    std::vector<Integrator> integrators{Integrator::Auto};
    integrators.insert(integrators.end(), allIntegrators.begin(), allIntegrators.end());
    return integrators;
}

/// Whether a step lets the pull alone throw its node farther than springs are long. A step is chosen for the
/// tissue, before anything pulls at it, and no integrator that solves a linear system can follow that.
bool isThrown(const ExtremeCase& tested, Integrator integrator) {
    SimulationSettings settings;
    settings.integrator = integrator;
    const double step = chooseStep(tested.model, settings).timeStep;
    const double length = tested.model.network->springs.front().restLength;
    return tested.force.norm() * step * step / tested.model.mass[tested.pulledNode] > length;
}

class ExtremesOf : public testing::TestWithParam<Integrator> {};
INSTANTIATE_TEST_SUITE_P(Dynamics, ExtremesOf, testing::ValuesIn(integratorsAndAuto()), nameOfIntegratorTest);

// `esmc extremes` runs all of them, for longer.
TEST_P(ExtremesOf, RunOrEndWithAReason) {
    const Sweep tried = sweep();
    const std::vector<ExtremeCase> cases = extremeCases();
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const bool isOneOfMany = cases[i].timeStep || cases[i].family == cases.front().family;
        if (isOneOfMany && i % tried.everyCase != 0) continue;
        SCOPED_TRACE(cases[i].family + ": " + cases[i].name);
        const ExtremeOutcome outcome = runExtreme(cases[i], GetParam(), tried.steps / 4);
        EXPECT_EQ(outcome.reason.empty(), outcome.end == ExtremeEnd::Ran) << outcome.reason;
        // A step that was chosen safely must hold.
        if (outcome.end == ExtremeEnd::Stopped && !cases[i].timeStep) {
            EXPECT_TRUE(isThrown(cases[i], GetParam())) << outcome.reason;
        }
    }
}

// Springs resist their collapse, which bounds the swings of steps that are a little too long.
TEST(Extremes, StopWhereEnergyComesOutOfNothing) {
    ExtremeCase tooLong = extremeCases().front();
    tooLong.model = tissue::fromMesh(tissue::sphereMesh(2, 0.05), {50, 0.02, 0.0001});
    tooLong.model.fixedNodes = {0, 1, 2};
    tooLong.force = {0, 0, 1e-6};
    const auto limit = criticalStep(tooLong.model, Integrator::Euler, {1e-3, Deformation::AtRest, {}});
    tooLong.timeStep = 1.05 * *limit;
    const ExtremeOutcome outcome = runExtreme(tooLong, Integrator::Euler, 2000);
    EXPECT_EQ(outcome.end, ExtremeEnd::Stopped);
    EXPECT_THAT(outcome.reason, testing::HasSubstr("energy out of nothing"));
    tooLong.timeStep = 0.97 * *limit;
    EXPECT_EQ(runExtreme(tooLong, Integrator::Euler, 2000).end, ExtremeEnd::Ran);
}

} // namespace
