#include "core/dynamics/extremes.h"
#include "core/dynamics/simulation.h"
#include "core/support/errors.h"
#include "tests/support/tissue_models.h"

#include <gmock/gmock.h>

using namespace esm;

namespace {

// Built with the sanitizers a step takes tens of times longer: they get the outermost corners only.
#ifdef ESM_SANITIZE
const std::vector<double> springConstants{1e-6, 1e9}, viscosities{0.0, 1.0, 1e6}, masses{1e-9, 1e3};
constexpr int stepsEach = 20;
constexpr std::size_t everyCase = 19;
#else
const std::vector<double> springConstants{1e-6, 1.0, 1e4, 1e9}, viscosities{0.0, 1e-6, 1.0, 1e3, 1e6},
    masses{1e-9, 1e-3, 1e3};
constexpr int stepsEach = 200;
constexpr std::size_t everyCase = 7; // meets every value of every parameter
#endif

// Every corner of what sliders and files can ask for: a run stays whole or is refused with a reason.
TEST(Extremes, StayWholeOrAreRefused) {
    const TriangleMesh mesh = tissue::sphereMesh(1, 0.05);
    int ran = 0, refused = 0;
    for (const double springConstant : springConstants)
        for (const double viscosity : viscosities)
            for (const double mass : masses)
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
                            for (int i = 0; i < stepsEach; ++i) {
                                if (i == stepsEach / 2) loads = Loads{};
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

class ExtremesOf : public testing::TestWithParam<Integrator> {};
INSTANTIATE_TEST_SUITE_P(Dynamics, ExtremesOf, testing::ValuesIn(integratorsAndAuto()),
                         [](const auto& tested) {
                             std::string name = integratorName(tested.param);
                             std::replace(name.begin(), name.end(), '-', '_');
                             return name;
                         });

// `esmc extremes` runs all of them, for longer.
TEST_P(ExtremesOf, RunOrEndWithAReason) {
    const std::vector<ExtremeCase> cases = extremeCases();
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const bool isOneOfMany = cases[i].timeStep || cases[i].family == cases.front().family;
        if (isOneOfMany && i % everyCase != 0) continue;
        SCOPED_TRACE(cases[i].family + ": " + cases[i].name);
        const ExtremeOutcome outcome = runExtreme(cases[i], GetParam(), stepsEach / 4);
        EXPECT_EQ(outcome.reason.empty(), outcome.end == ExtremeEnd::Ran) << outcome.reason;
        // A step that was chosen safely must hold.
        if (!cases[i].timeStep) {
            EXPECT_NE(outcome.end, ExtremeEnd::Stopped) << outcome.reason;
        }
    }
}

} // namespace
