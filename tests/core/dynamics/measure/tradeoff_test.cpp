#include "core/dynamics/measure/tradeoff.h"

#include "core/authoring/coarser_runs.h"
#include "core/support/errors.h"
#include "tests/support/sanitized.h"
#include "tests/support/tissue_models.h"

#include <gmock/gmock.h>

#include <cmath>
#include <memory>

using namespace esm;

namespace {

constexpr double mostSeconds = 0.08; ///< of one run, by the clock below

/// A clock that every reading sets on, each by a little more than the one before where it slows down: steps
/// take as long on every machine.
TimeSource setOnByReading(double seconds, double slowing = 0) {
    return [now = std::make_shared<double>(0), tick = std::make_shared<double>(seconds), slowing] {
        *tick += slowing;
        return *now += *tick;
    };
}

TradeoffOptions optionsFor(const TradeoffWishes& wishes, double seconds = mostSeconds) {
    TradeoffOptions options{wishes, seconds};
    options.clock = setOnByReading(2e-5);
    return options;
}

/// A force on one node of the published tube for a second.
struct PulledTube {
    TissueModel model = tissue::fallopianTube();
    Scene scene;

    PulledTube() {
        scene.forces = {{85, {0, 0, 0.1}, 0, 1}};
        scene.record.every = 0.05;
    }
    Tradeoff measured(const TradeoffOptions& options, const Progress& progress = {},
                      const TradeoffSink& sink = {}) const {
        return measureTradeoff({model, {}, scene}, options, progress, sink);
    }
};

/// Those that take thousands of steps in runs like those of the others.
struct LongTradeoff : testing::Test {
    void SetUp() override {
        if (isSanitized()) GTEST_SKIP() << "more of the same steps show nothing more to the sanitizers";
    }
};

} // namespace

TEST(Tradeoff, MeasuresThePublishedTube) {
    double reported = 0;
    std::vector<double> asTheyCome;
    const auto progress = [&](double fraction) {
        EXPECT_GE(fraction, reported);
        reported = fraction;
        return true;
    };
    const auto take = [&](const TradeoffRun& run) { asTheyCome.push_back(run.error); };
    const auto takeReference = [&](const TradeoffReference& reference) {
        EXPECT_TRUE(asTheyCome.empty());
        EXPECT_GT(reference.estimatedError, 0);
    };
    Tradeoff tradeoff = PulledTube().measured(optionsFor({1, 0.01}), progress, {takeReference, take});
    std::vector<double> atTheEnd;
    for (const TradeoffRun& run : tradeoff.runs)
        atTheEnd.push_back(run.error);
    EXPECT_EQ(asTheyCome, atTheEnd);
    EXPECT_GT(reported, 0.9);
    EXPECT_GT(tradeoff.reference.estimatedError, 0);
    for (const TradeoffRun& run : tradeoff.runs) {
        EXPECT_TRUE(run.stable) << integratorName(run.stepping.integrator) << run.stepping.timeStep;
        EXPECT_GE(run.error, (run.isErrorBound ? 1 : 10) * tradeoff.reference.estimatedError);
    }
    // Published: 1.3e-3 at 0.05 s, 5.5e-5 at 0.01 s, measured at the end alone.
    const auto split2 = std::find_if(tradeoff.runs.begin(), tradeoff.runs.end(), [](const TradeoffRun& run) {
        return run.stepping.integrator == Integrator::Split2 && run.stepping.timeStep == 0.05;
    });
    ASSERT_NE(split2, tradeoff.runs.end());
    EXPECT_LT(split2->error, 0.02);

    ASSERT_TRUE(tradeoff.fastestToError);
    EXPECT_LE(tradeoff.runs[*tradeoff.fastestToError].error, 0.01);

    ASSERT_FALSE(tradeoff.pareto.empty());
    for (const std::size_t i : tradeoff.pareto)
        for (const TradeoffRun& other : tradeoff.runs) {
            const TradeoffRun& run = tradeoff.runs[i];
            EXPECT_FALSE(other.error < run.error &&
                         other.wallPerSimulatedSecond < run.wallPerSimulatedSecond);
        }
}

TEST_F(LongTradeoff, KeepsRunsAsExactAsTheReference) {
    PulledTube tube;
    tube.scene.duration = 0.2;
    TradeoffOptions options = optionsFor({1, 0.3});
    const Tradeoff tradeoff = tube.measured(options);
    std::size_t bounded = 0;
    for (const TradeoffRun& run : tradeoff.runs) {
        if (!run.isErrorBound) continue;
        EXPECT_GE(run.error, tradeoff.reference.estimatedError);
        EXPECT_LE(run.error, 11 * tradeoff.reference.estimatedError);
        ++bounded;
    }
    EXPECT_GT(bounded, 0U);
}

TEST_F(LongTradeoff, GoesOnToTheErrorThatIsWanted) {
    PulledTube tube;
    tube.scene.duration = 0.2;
    const auto runsOfSplit = [&](double mostError) {
        const Tradeoff tradeoff = tube.measured(optionsFor({1, mostError}));
        return std::count_if(tradeoff.runs.begin(), tradeoff.runs.end(), [](const TradeoffRun& run) {
            return run.stepping.integrator == Integrator::Split;
        });
    };
    EXPECT_GT(runsOfSplit(1e-4), runsOfSplit(0.01));
}

TEST_F(LongTradeoff, FindsAReferenceWhereRegionsHaveNoViscosity) {
    PulledTube tube;
    for (std::size_t node = 0; node < 40; ++node)
        tube.model.viscosity[node] = 0;
    const Tradeoff tradeoff = tube.measured(optionsFor({1, 0.01}, mostSeconds / 4));
    EXPECT_EQ(tradeoff.reference.stepping.integrator, Integrator::Split);
    EXPECT_FALSE(tradeoff.reference.hidesSwings);
    EXPECT_FALSE(tradeoff.runs.empty());
}

TEST(Tradeoff, SaysWhyThereIsNoReference) {
    PulledTube tube;
    tube.model.viscosity.assign(tube.model.mass.size(), 0);
    tube.model.springConstant.assign(tube.model.mass.size(), 1e12);
    try {
        tube.measured(optionsFor({1, 0.01}, 1e-5));
        FAIL() << "in no time";
    } catch (const InvalidModel& refused) {
        EXPECT_THAT(refused.what(),
                    testing::AllOf(testing::HasSubstr("split2: no step is stable"),
                                   testing::HasSubstr("rk4: "), testing::HasSubstr("bdf2: ")));
    }
}

TEST_F(LongTradeoff, StopsWhatTakesLongerThanItsFirstSteps) {
    PulledTube tube;
    tube.scene.duration = 0.2;
    TradeoffOptions options = optionsFor({1, 0.3});
    options.clock = setOnByReading(2e-5, 1e-9);
    std::vector<double> reported;
    const auto progress = [&](double fraction) {
        reported.push_back(fraction);
        return true;
    };
    const Tradeoff tradeoff = tube.measured(options, progress);
    EXPECT_THAT(tradeoff.leftOut, testing::Contains(testing::Field(
                                      &LeftOutRun::reason, testing::HasSubstr("took longer than the"))));
    EXPECT_TRUE(std::is_sorted(reported.begin(), reported.end()));
}

TEST(Tradeoff, RecommendsAnewForOtherWishes) {
    Tradeoff tradeoff;
    const auto add = [&](double error, double cost, bool stable = true) {
        TradeoffRun run;
        run.stable = stable;
        run.error = error;
        run.wallPerSimulatedSecond = cost;
        tradeoff.runs.push_back(run);
    };
    add(1e-4, 4);
    add(1e-2, 0.1);
    add(2e-2, 0.2);
    add(1e-3, 0.9);
    add(1e-9, 0.01, false);
    add(1.2, 0.001); // fast, and farther off than tissue that stands still
    recommend(tradeoff, {1, 1e-2});
    EXPECT_THAT(tradeoff.pareto, testing::ElementsAre(1, 3, 0));
    EXPECT_EQ(tradeoff.bestInRealTime, 3U);
    EXPECT_EQ(tradeoff.fastestToError, 1U);
    recommend(tradeoff, {0.2, 2e-4});
    EXPECT_EQ(tradeoff.bestInRealTime, 0U);
    EXPECT_EQ(tradeoff.fastestToError, 0U);
    recommend(tradeoff, {100, 1e-5});
    EXPECT_FALSE(tradeoff.bestInRealTime);
    EXPECT_FALSE(tradeoff.fastestToError);
}

TEST(Tradeoff, SaysWhenNothingMoves) {
    PulledTube tube;
    tube.scene.forces.clear();
    EXPECT_THROW(tube.measured(optionsFor({1, 0.01})), InvalidModel);
}

TEST_F(LongTradeoff, ComparesAtTheEndWhatIsRecordedLessOften) {
    PulledTube tube;
    tube.scene.duration = 0.2;
    tube.scene.record.every = 1;
    const Tradeoff tradeoff = tube.measured(optionsFor({1, 0.01}));
    EXPECT_FALSE(tradeoff.runs.empty());
}

TEST(Tradeoff, StopsWhenAsked) {
    int calls = 0;
    EXPECT_THROW(PulledTube().measured(optionsFor({1, 0.01}), [&](double) { return ++calls < 20; }),
                 Cancelled);
}

TEST_F(LongTradeoff, MeasuresFewerNodesAgainstAll) {
    Project project = makeProject("ball", {tissue::sphereMesh(3, 0.1), {}});
    Scene scene = project.scene;
    scene.duration = 0.4;
    scene.gravity = {0, -20, 0};
    scene.fixed = {{{}, Ellipsoid{{0, 0.1, 0}, {0.08, 0.05, 0.08}, Eigen::Quaterniond::Identity()}}};
    scene.record.every = 0.1;
    scene.record.nodes = std::vector<std::uint32_t>{1, 7, 100};
    TradeoffOptions options = optionsFor({1, 0.01}, mostSeconds / 8);
    options.coarser = coarserRuns(project, scene);
    ASSERT_EQ(options.coarser.size(), 1U);
    const TissueModel model = evaluateModel(project, scene);
    const Tradeoff tradeoff = measureTradeoff({model, {}, scene}, options);
    double least = 1, leastOnFewer = 1;
    for (const TradeoffRun& run : tradeoff.runs) {
        EXPECT_THAT(run.nodes, testing::AnyOf(642U, 160U));
        double& best = run.nodes == 642 ? least : leastOnFewer;
        if (run.stable) best = std::min(best, run.error);
    }
    EXPECT_LT(least, 0.01);
    EXPECT_GT(leastOnFewer, least);
    EXPECT_LT(leastOnFewer, 0.5);
}
