#include "core/dynamics/tradeoff.h"
#include "core/support/errors.h"
#include "tests/support/tissue_models.h"

#include <gmock/gmock.h>

#include <cmath>

using namespace esm;

namespace {

constexpr double mostSeconds = 0.1; ///< of one run

/// A force on one node of the published tube for a second.
struct PulledTube {
    TissueModel model = tissue::fallopianTube();
    Scene scene;

    PulledTube() {
        scene.forces = {{85, {0, 0, 0.1}, 0, 1}};
        scene.record.every = 0.05;
    }
    Tradeoff measured(const TradeoffOptions& options, const Progress& progress = {}) const {
        return measureTradeoff({model, {}, scene}, options, progress);
    }
};

} // namespace

TEST(Tradeoff, MeasuresThePublishedTube) {
    double reported = 0;
    const Tradeoff tradeoff = PulledTube().measured({1, 0.01, mostSeconds}, [&](double fraction) {
        EXPECT_GE(fraction, reported);
        reported = fraction;
        return true;
    });
    EXPECT_GT(reported, 0.9);
    EXPECT_GT(tradeoff.reference.estimatedError, 0);
    for (const TradeoffRun& run : tradeoff.runs) {
        EXPECT_TRUE(run.stable) << integratorName(run.stepping.integrator) << run.stepping.timeStep;
        EXPECT_GE(run.error, 10 * tradeoff.reference.estimatedError);
    }
    // Published: 1.3e-3 at 0.05 s, 5.5e-5 at 0.01 s, measured at the end alone.
    const auto split2 = std::find_if(tradeoff.runs.begin(), tradeoff.runs.end(), [](const TradeoffRun& run) {
        return run.stepping.integrator == Integrator::Split2 && run.stepping.timeStep == 0.05;
    });
    ASSERT_NE(split2, tradeoff.runs.end());
    EXPECT_LT(split2->error, 0.02);

    ASSERT_TRUE(tradeoff.fastestToError);
    const TradeoffRun& fastest = tradeoff.runs[*tradeoff.fastestToError];
    EXPECT_THAT(fastest.stepping.integrator, testing::AnyOf(Integrator::Split, Integrator::Split2));
    EXPECT_GE(fastest.stepping.timeStep, 0.02);
    ASSERT_TRUE(tradeoff.bestInRealTime);
    EXPECT_LT(tradeoff.runs[*tradeoff.bestInRealTime].error, 1e-3);

    ASSERT_FALSE(tradeoff.pareto.empty());
    for (const std::size_t i : tradeoff.pareto)
        for (const TradeoffRun& other : tradeoff.runs) {
            const TradeoffRun& run = tradeoff.runs[i];
            EXPECT_FALSE(other.error < run.error &&
                         other.wallPerSimulatedSecond < run.wallPerSimulatedSecond);
        }
}

TEST(Tradeoff, SaysWhenNothingMoves) {
    PulledTube tube;
    tube.scene.forces.clear();
    EXPECT_THROW(tube.measured({1, 0.01, mostSeconds}), InvalidModel);
}

TEST(Tradeoff, StopsWhenAsked) {
    int calls = 0;
    EXPECT_THROW(PulledTube().measured({1, 0.01, mostSeconds}, [&](double) { return ++calls < 20; }),
                 Cancelled);
}
