#include "app/editor/workers/preview.h"

#include "core/authoring/fluids.h"
#include "tests/app/editor/workers/preview_projects.h"
#include "tests/support/eventually.h"

#include <gtest/gtest.h>
#include <QTest>

#include <algorithm>
#include <atomic>
#include <functional>

using namespace esm;

namespace {

/// Whether the preview has taken all that was handed to it before, which it does in order: a last project is
/// handed to it, and comes out with a frame.
bool hasTakenAll(Preview& preview, const Project& last, int number) {
    preview.setProject(last);
    return QTest::qWaitFor([&] { return preview.frame().project == number; }, patience);
}

/// As it is once that holds; else the test fails.
PreviewStatus statusWhen(const Preview& preview, const std::function<bool(const PreviewStatus&)>& holds) {
    PreviewStatus status;
    const auto look = [&] {
        status = preview.status();
        return holds(status);
    };
    EXPECT_TRUE(QTest::qWaitFor(look, patience));
    return status;
}

} // namespace

TEST(Preview, TellsWhatTheLastProjectIsMadeOfAndNothingOlder) {
    Preview preview;
    EXPECT_FALSE(preview.tissue());
    Project tube = makeSample("tube");
    preview.setProject(tube);
    ESM_EVENTUALLY(preview.tissue());
    EXPECT_EQ(preview.tissue()->network, tube.network);
    EXPECT_EQ(preview.tissue()->mass, evaluateModel(tube).mass);
    tube.base.mass *= 2;
    preview.setProject(tube);
    ESM_EVENTUALLY(preview.tissue());
    EXPECT_EQ(preview.tissue()->mass, evaluateModel(tube).mass);
}

TEST(Preview, KnowsWhetherItIsToPlayBeforeTheOrganIsPrepared) {
    Preview preview;
    preview.setPlaying(true);
    preview.setProject(makeSample("liver"));
    preview.setPlaying(false);
    EXPECT_FALSE(preview.isToPlay());
    preview.togglePlaying();
    EXPECT_TRUE(preview.isToPlay());
}

TEST(Preview, PausesWhereItsSceneEnds) {
    Project project = makeSample("tube");
    project.scene.duration = 0.1;
    project.scene.forces = {{20, {0, 0, 0.01}, 0, 0.1}};
    Preview preview;
    preview.setProject(project);
    preview.playScene();
    // In this order: before it begins it does not play either.
    ESM_EVENTUALLY(preview.frame().project == 1 &&
                   preview.frame().positions != project.network->restPositions && !preview.status().playing);
    EXPECT_TRUE(preview.status().failure.empty());
    preview.reset();
    ESM_EVENTUALLY(preview.frame().positions == project.network->restPositions);
}

TEST(Preview, SaysWhyARefusedModelDoesNotPlay) {
    Preview preview;
    preview.setProject(refusedProject());
    preview.togglePlaying();
    ASSERT_TRUE(QTest::qWaitFor([&] { return !preview.status().failure.empty(); }, patience));
    preview.togglePlaying();
    ASSERT_TRUE(hasTakenAll(preview, refusedProject(), 2));
    EXPECT_FALSE(preview.status().playing);
    EXPECT_NE(preview.status().failure, "");
}

class BurstPreview : public testing::Test {
protected:
    void SetUp() override {
        liver.scene.tethers.clear(); // which would bear a part of it
        burst();
    }
    void burst() {
        pressPart(liver, 0, 1e5);
        preview.setProject(liver);
        preview.setPlaying(true);
        ESM_EVENTUALLY(!preview.status().failure.empty() && !preview.status().playing);
    }
    void lowerPressure() {
        pressPart(liver, 0, 5);
        preview.setProject(liver);
    }

    Project liver = makeSample("liver");
    Preview preview;
};

TEST_F(BurstPreview, PlaysOnFromRestOnceItBearsItsPressure) {
    preview.reset();
    ESM_EVENTUALLY(preview.frame().positions == liver.network->restPositions);
    EXPECT_FALSE(preview.status().playing);
    lowerPressure();
    ESM_EVENTUALLY(preview.status().failure.empty() && preview.status().playing);
    ESM_EVENTUALLY(!preview.status().fluids.empty());
    EXPECT_LT(preview.status().fluids.at(0).share, 2) << "it does not go on from where it burst";
}

TEST_F(BurstPreview, StaysPausedWhereTheUserPausedIt) {
    preview.setPlaying(false);
    lowerPressure();
    ASSERT_TRUE(hasTakenAll(preview, liver, 3));
    EXPECT_FALSE(preview.status().playing);
}

TEST_F(BurstPreview, ARecordingThatBeginsMeanwhileGoesOn) {
    preview.record();
    lowerPressure();
    ASSERT_TRUE(hasTakenAll(preview, liver, 3));
    ESM_EVENTUALLY(preview.status().failure.empty() && preview.status().playing);
    EXPECT_TRUE(preview.isRecording());
}

TEST(Preview, SaysWhatWentWrongOutsideTheSimulationAndLivesOn) {
    std::atomic<bool> broken = true; // outlives the thread that asks
    Preview preview;
    QObject::connect(&preview, &Preview::frameReady, [&broken] {
        if (broken) throw std::runtime_error("no reason");
    });
    preview.setProject(makeSample("tube"));
    ASSERT_TRUE(QTest::qWaitFor([&] { return preview.status().failure == "no reason"; }, patience));
    EXPECT_FALSE(preview.status().playing);
    broken = false;
    preview.frame();
    preview.togglePlaying();
    EXPECT_TRUE(QTest::qWaitFor([&] { return preview.status().playing; }, patience));
    EXPECT_EQ(preview.status().failure, "");
}

TEST(Preview, PlaysAfterAnOddNumberOfToggles) {
    Preview preview;
    preview.setProject(makeSample("tube"));
    for (int i = 0; i < 3; ++i)
        preview.togglePlaying();
    ASSERT_TRUE(QTest::qWaitFor([&] { return preview.status().playing; }, patience));
    preview.togglePlaying();
    preview.togglePlaying();
    ASSERT_TRUE(hasTakenAll(preview, makeSample("tube"), 2));
    EXPECT_TRUE(preview.status().playing);
    preview.togglePlaying();
    EXPECT_TRUE(QTest::qWaitFor([&] { return !preview.status().playing; }, patience));
}

TEST(Preview, LearnsHowFarTheStepMayGo) {
    Preview preview;
    preview.setProject(makeSample("tube"));
    ASSERT_TRUE(QTest::qWaitFor([&] { return preview.status().safeStep.has_value(); }, patience));
    EXPECT_GT(*preview.status().safeStep, preview.status().timeStep);
}

TEST(Preview, TellsWhenItLearntHowFarTheStepMayGo) {
    std::atomic<bool> isTold = false;
    Preview preview;
    QObject::connect(&preview, &Preview::statusChanged,
                     [&] { isTold = isTold || preview.status().safeStep.has_value(); });
    preview.setProject(makeSample("tube"));
    EXPECT_TRUE(QTest::qWaitFor([&] { return isTold.load(); }, patience));
}

TEST(Preview, LearnsItAnewOfTheIntegratorThatTookOver) {
    Preview preview;
    preview.setGentleMotion(true);
    preview.setProject(steppedTooLong(1000));
    preview.setPlaying(true);
    const PreviewStatus status = statusWhen(
        preview, [&](const PreviewStatus& now) { return now.replaced != Replaced::Not && now.safeStep; });
    EXPECT_GT(status.safeStep.value_or(0), status.timeStep);
}

// Nothing touches the tissue, which would look calm.
TEST(Preview, AStepFarBeyondTheSafeOneIsReplacedBeforeTheTissueRunsWild) {
    Preview preview;
    preview.setProject(steppedTooLong(1000));
    preview.setPlaying(true);
    const PreviewStatus status = statusWhen(preview, [&](const PreviewStatus& now) {
        return now.replaced == Replaced::BeyondSafe && now.safeStep && now.timeStep <= *now.safeStep;
    });
    EXPECT_TRUE(status.playing);
}

TEST(Preview, NeverSetsTheStepBesideTheLimitOfOtherParameters) {
    Project project = makeSample("tube");
    project.regions.clear(); // the base tissue is to be seen
    Preview preview;
    preview.setProject(project);
    ASSERT_TRUE(QTest::qWaitFor([&] { return preview.status().safeStep.has_value(); }, patience));
    const PreviewStatus before = preview.status();
    project.base.springConstant *= 1e4;
    preview.setProject(project);
    const PreviewStatus after =
        statusWhen(preview, [&](const PreviewStatus& now) { return now.timeStep != before.timeStep; });
    EXPECT_NE(after.safeStep, before.safeStep);
    EXPECT_TRUE(QTest::qWaitFor([&] { return preview.status().safeStep.has_value(); }, patience));
}

TEST(SafeStepFinder, TellsOnlyTheLatestModelsStep) {
    const TissueModel tube = evaluateModel(makeSample("tube")),
                      ventricle = evaluateModel(makeSample("ventricle"));
    std::atomic<double> told = 0;
    SafeStepFinder finder([&](std::optional<double> step) { told = step.value_or(0); });
    finder.find(ventricle, Integrator::Split);
    finder.find(tube, Integrator::Euler);
    const double expected = *criticalSteps(tube).at(Integrator::Euler);
    ESM_EVENTUALLY(told > 0);
    EXPECT_NEAR(told, expected, 0.05 * expected);
}
