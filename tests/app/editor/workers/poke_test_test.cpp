#include "app/editor/workers/poke_test.h"

#include "tests/app/editor/workers/poked_organ.h"
#include "tests/support/eventually.h"

#include <gmock/gmock.h>

using namespace esm;

namespace {

class PokeTestTest : public testing::Test {
protected:
    PokeTestTest() : document(pokedOrgan()), test(document, preview) {
        QObject::connect(&document, &Document::changed, &preview,
                         [this] { preview.setProject(document.project()); });
        preview.setProject(document.project());
    }

    /// A pull by hand, and what it comes to.
    void poke() {
        test.record();
        ESM_EVENTUALLY(test.recordedTime() > 0.1);
        preview.setPull(
            Pull{40, document.project().network->restPositions[40] + Eigen::Vector3d(0.02, 0, 0)});
        const double taken = test.recordedTime();
        ESM_EVENTUALLY(test.recordedTime() > taken + 0.2);
        preview.setPull(std::nullopt);
        test.stop();
        ESM_EVENTUALLY(!test.isComputing());
    }
    void repeat() {
        test.repeat();
        ESM_EVENTUALLY(!test.isComputing());
    }
    void stiffen() {
        document.edit("stiffen", [](Project& project) {
            for (Region& region : project.regions)
                region.held.springConstant = 3 * region.held.springConstant.value_or(100);
        });
    }
    static double largestForce(const PokeTest::Motion& motion) {
        double most = 0;
        for (const PokePicture& picture : motion->pictures)
            most = std::max(most, picture.force);
        return most;
    }

    Document document;
    Preview preview;
    PokeTest test;
};

TEST_F(PokeTestTest, ComparesTheOrganWithWhatItWasBefore) {
    EXPECT_FALSE(test.obstacle().isEmpty());
    poke();
    ASSERT_TRUE(test.latest()) << test.failure();
    EXPECT_GT(largestForce(test.latest()), 0);
    EXPECT_FALSE(test.former());
    EXPECT_GT(test.player().duration(), 0.3 - 1.0 / pokePicturesPerSecond);
    repeat();
    EXPECT_FALSE(test.former()) << "the same organ again is nothing to compare with";
    const PokeTest::Motion soft = test.latest();
    stiffen();
    EXPECT_TRUE(test.isOutdated());
    repeat();
    EXPECT_FALSE(test.isOutdated());
    EXPECT_EQ(test.former(), soft);
    EXPECT_GT(largestForce(test.latest()), 1.2 * largestForce(soft));
    test.forgetFormer();
    EXPECT_FALSE(test.former());
}

TEST_F(PokeTestTest, ARecordingWithoutAHandLeavesThePokeBefore) {
    poke();
    const PokeTest::Motion motion = test.latest();
    test.record();
    ESM_EVENTUALLY(test.recordedTime() > 0.1);
    test.stop();
    EXPECT_EQ(test.latest(), motion);
    EXPECT_THAT(test.failure(), testing::HasSubstr("touched nothing"));
    EXPECT_TRUE(test.obstacle().isEmpty());
    repeat();
    EXPECT_TRUE(test.failure().empty());
}

TEST_F(PokeTestTest, ARecordingThatIsResetEndsWithAWord) {
    test.record();
    ESM_EVENTUALLY(test.recordedTime() > 0.1);
    preview.reset();
    ESM_EVENTUALLY(!test.isRecording());
    EXPECT_THAT(test.failure(), testing::HasSubstr("record again"));
    EXPECT_FALSE(test.poke());
}

TEST_F(PokeTestTest, AnotherNetWhileItIsRecordedEndsItWithAWord) {
    poke();
    const PokeTest::Motion motion = test.latest();
    test.record();
    ESM_EVENTUALLY(test.recordedTime() > 0.1);
    preview.setPull(Pull{40, document.project().network->restPositions[40] + Eigen::Vector3d(0.02, 0, 0)});
    ESM_EVENTUALLY(preview.status().pull.has_value());
    document.edit("fewer", [](Project& project) {
        project = withDetail(project, {Detail::Kind::Nodes, 300});
    });
    EXPECT_FALSE(test.isRecording());
    EXPECT_FALSE(preview.isRecording());
    EXPECT_EQ(test.latest(), motion);
    EXPECT_THAT(test.failure(), testing::HasSubstr("other nodes"));
}

TEST_F(PokeTestTest, AnotherNetOfTheOrganIsComparedToo) {
    poke();
    const PokeTest::Motion fine = test.latest();
    ASSERT_TRUE(fine);
    document.edit("fewer", [](Project& project) {
        project = withDetail(project, {Detail::Kind::Nodes, 300});
    });
    EXPECT_TRUE(test.isOutdated());
    EXPECT_EQ(test.player().duration(), 0) << "the organ that is shown has other nodes";
    repeat();
    EXPECT_EQ(test.former(), fine);
    EXPECT_GT(test.player().duration(), 0);
}

TEST_F(PokeTestTest, OfTheSceneOnlyWhatLastsMakesAMotionOutdated) {
    poke();
    document.edit("scene", [](Project& project) {
        project.scene.duration = 7;
        project.scene.moves = {{3, {{0, {0, 0, 0}}, {1, {0, 0, 0.01}}}}};
    });
    EXPECT_FALSE(test.isOutdated());
    document.edit("gravity", [](Project& project) { project.scene.gravity = {0, 0, -1}; });
    EXPECT_TRUE(test.isOutdated());
}

TEST_F(PokeTestTest, WhatIsKeptStaysUnderAnotherPoke) {
    poke();
    const PokeTest::Motion first = test.latest();
    ASSERT_TRUE(first);
    test.keepLatest();
    poke();
    EXPECT_NE(test.latest(), first);
    EXPECT_EQ(test.former(), first);
}

TEST_F(PokeTestTest, TheSceneEndsARecordingAndLeavesNothing) {
    test.record();
    ESM_EVENTUALLY(test.recordedTime() > 0);
    preview.playScene();
    ESM_EVENTUALLY(!test.isRecording());
    EXPECT_FALSE(test.poke());
    EXPECT_FALSE(test.obstacle().isEmpty());
}

TEST_F(PokeTestTest, AnotherOrganForgetsThePoke) {
    poke();
    ASSERT_TRUE(test.latest());
    test.player().play();
    document.replace(makeSample("tube"), std::nullopt);
    EXPECT_FALSE(test.poke());
    EXPECT_FALSE(test.latest());
    EXPECT_FALSE(test.player().isShown());
}

} // namespace
