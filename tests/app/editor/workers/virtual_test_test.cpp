#include "app/editor/workers/virtual_test.h"

#include "tests/app/editor/panels/measure/pressed_organ.h"

#include <gmock/gmock.h>

using namespace esm;

namespace {

class VirtualTestTest : public PressedOrgan {};

class VirtualTestInTime : public PressedOrgan {
protected:
    VirtualTestInTime() : PressedOrgan(solidDetail()) {}
};

TEST_F(VirtualTestTest, PressesOnceAPlaceIsChosenAndTheTissueIsThere) {
    awaitTissue();
    EXPECT_FALSE(test.obstacle().isEmpty());
    test.press();
    EXPECT_FALSE(test.isPressing());
    test.choosePlace(placeIn(5));
    EXPECT_EQ(test.obstacle(), QString());
    measure();
    ASSERT_TRUE(test.latest()) << test.failure();
    const ProbeResult& result = test.latest()->result;
    EXPECT_NEAR(result.curve.back().depth, 0.001, 1e-9);
    EXPECT_GT(result.curve.back().force, 0);
    EXPECT_LT((result.place - *test.restPlace()).norm(), 0.005);
    EXPECT_FALSE(test.former());
    EXPECT_FALSE(test.isOutdated());
}

TEST_F(VirtualTestTest, WhatIsCancelledGivesNoResultAndTheNextDoes) {
    test.choosePlace(placeIn(5));
    awaitTissue();
    test.press();
    EXPECT_TRUE(test.isPressing());
    test.cancel();
    EXPECT_FALSE(test.isPressing());
    EXPECT_FALSE(test.latest());
    test.setDepth(0.002);
    measure();
    ASSERT_TRUE(test.latest());
    EXPECT_NEAR(test.latest()->result.curve.back().depth, 0.002, 1e-9) << "and not that of the first";
}

TEST_F(VirtualTestTest, AnotherTissueIsComparedWithTheOneBefore) {
    test.choosePlace(placeIn(5));
    measure();
    const VirtualTest::Press soft = test.latest();
    ASSERT_TRUE(soft);
    measure();
    EXPECT_FALSE(test.former()) << "the same tissue again is nothing to compare with";
    stiffen();
    ESM_EVENTUALLY(test.isOutdated());
    document.undoStack()->undo();
    ESM_EVENTUALLY(!test.isOutdated());
    document.undoStack()->redo();
    ESM_EVENTUALLY(test.isOutdated());
    measure();
    EXPECT_FALSE(test.isOutdated());
    ASSERT_TRUE(test.former());
    EXPECT_NEAR(test.former()->result.curve.back().force, soft->result.curve.back().force, 1e-9);
    EXPECT_GT(test.latest()->result.curve.back().force, 1.2 * test.former()->result.curve.back().force);
    test.setDepth(0.0015);
    measure();
    EXPECT_TRUE(test.former()) << "the same finger at the same place";
    test.choosePlace(placeIn(6));
    measure();
    EXPECT_FALSE(test.former()) << "another place says nothing of the tissue";
}

TEST_F(VirtualTestTest, AnotherFluidWithinIsAnotherOrgan) {
    test.choosePlace(placeIn(5));
    const auto fill = [&](double stiffness) {
        document.edit("fill", [&](Project& project) { project.scene.fillings = {{0, stiffness}}; });
    };
    fill(1000);
    measure();
    ASSERT_TRUE(test.latest()) << test.failure();
    fill(2000);
    ESM_EVENTUALLY(test.isOutdated());
}

TEST_F(VirtualTestTest, AnotherPressureWithinIsAnotherOrgan) {
    test.choosePlace(placeIn(5));
    const auto press = [&](const std::vector<PressurePoint>& path) {
        document.edit("press", [&](Project& project) { project.scene.pressures = {{0, path}}; });
    };
    press({{0, 5}});
    measure();
    ASSERT_TRUE(test.latest()) << test.failure();
    ASSERT_EQ(test.latest()->result.inflated.size(), 1U);
    EXPECT_GT(test.latest()->result.inflated[0].volume, test.latest()->result.inflated[0].restVolume);
    press({{0, 10}});
    ESM_EVENTUALLY(test.isOutdated());
    press({{0, 5}, {1, 200}});
    ESM_EVENTUALLY(!test.isOutdated()); // what comes later in the scene takes no part
}

TEST_F(VirtualTestTest, PullsAStripWhateverHoldsTheOrgan) {
    EXPECT_FALSE(test.stripFrame());
    test.choosePlace(placeIn(5));
    ASSERT_TRUE(test.stripFrame());
    test.chooseKind(TestKind::Strip);
    test.setStripLength(0.07);
    test.setStripWidth(0.04);
    test.setStretch(0.2);
    measure();
    ASSERT_TRUE(test.latest()) << test.failure();
    const StripResult soft = test.latest()->strip->result;
    EXPECT_GT(soft.curve.back().force, 0);
    EXPECT_GT(std::abs(soft.along.dot(test.stripFrame()->along)), 0.9) << "it is drawn as it is cut";
    document.edit("tethers", [](Project& project) { project.scene.tethers.clear(); });
    awaitTissue();
    EXPECT_FALSE(test.isOutdated()) << "a strip that is cut out is held by nothing";
    document.edit("thicker", [](Project& project) { project.base.wallThickness *= 2; });
    EXPECT_TRUE(test.isOutdated()) << "the modulus goes by the thickness";
    document.undoStack()->undo();
    EXPECT_FALSE(test.isOutdated());
    stiffen();
    ESM_EVENTUALLY(test.isOutdated());
    measure();
    ASSERT_TRUE(test.former());
    EXPECT_GT(test.latest()->strip->result.stiffness, 1.3 * soft.stiffness);
    test.setTurn(30);
    measure();
    EXPECT_FALSE(test.former()) << "another direction is another test";
}

TEST_F(VirtualTestTest, WhatIsKeptStaysWhateverIsMeasured) {
    test.choosePlace(placeIn(5));
    measure();
    const VirtualTest::Press kept = test.latest();
    ASSERT_TRUE(kept);
    test.keepLatest();
    test.choosePlace(placeIn(6));
    test.setRadius(0.005);
    measure();
    stiffen();
    measure();
    EXPECT_EQ(test.former(), kept);
    test.forgetFormer();
    EXPECT_FALSE(test.former());
    measure();
    EXPECT_FALSE(test.former());
}

TEST_F(VirtualTestTest, SaysWhatTheCoreSaysOfATestThatIsNone) {
    test.choosePlace(placeIn(5));
    measure();
    const VirtualTest::Press good = test.latest();
    ASSERT_TRUE(good);
    test.setDepth(0.9);
    measure();
    EXPECT_THAT(test.failure(), testing::HasSubstr("press less deep"));
    EXPECT_EQ(test.latest(), good) << "which stays";
    test.setDepth(0.001);
    measure();
    EXPECT_EQ(test.failure(), "");
}

TEST_F(VirtualTestTest, AnotherOrganHasNeitherPlaceNorResult) {
    test.choosePlace(placeIn(5));
    measure();
    ASSERT_TRUE(test.latest());
    test.press();
    document.replace(makeSample("tube"), std::nullopt);
    EXPECT_FALSE(test.isPressing());
    EXPECT_FALSE(test.place());
    EXPECT_FALSE(test.latest());
}

TEST_F(VirtualTestInTime, AStripIsDrawnAsItIsCut) {
    test.choosePlace(placeIn(5));
    test.chooseKind(TestKind::Strip);
    test.setStripLength(0.09);
    test.setStripWidth(0.045);
    measure();
    ASSERT_TRUE(test.latest()) << test.failure();
    EXPECT_GT(test.latest()->strip->result.along.dot(test.stripFrame()->along), 0.99);
    EXPECT_FALSE(test.latest()->strip->result.membraneStiffness);
}

TEST_F(VirtualTestInTime, StaysAndTellsHowTheForceFalls) {
    test.choosePlace(placeIn(5));
    test.chooseKind(TestKind::Stay);
    test.setDuration(0.5);
    measure();
    ASSERT_TRUE(test.latest()) << test.failure();
    const TimeCurve* curve = test.latest()->inTime();
    ASSERT_TRUE(curve);
    EXPECT_NEAR(curve->points.back().time, 0.5, 1e-9);
    EXPECT_NEAR(curve->end.depth, 0.001, 1e-9);
    ASSERT_TRUE(test.latest()->tissueTime);
    EXPECT_GT(*test.latest()->tissueTime, 0);
}

TEST_F(VirtualTestInTime, PushesWithWhatTheLastPressMetUntilAForceIsChosen) {
    test.choosePlace(placeIn(5));
    measure();
    ASSERT_TRUE(test.latest());
    const double met = test.latest()->result.curve.back().force;
    EXPECT_NEAR(test.force(), met, 0.05 * met) << "in two digits";
    test.chooseKind(TestKind::Push);
    test.setDuration(0.5);
    test.setDepth(0.9); // which a push does not ask for
    measure();
    ASSERT_TRUE(test.latest()) << test.failure();
    EXPECT_NEAR(test.latest()->inTime()->end.force, test.force(), 1e-3 * test.force());
    EXPECT_NEAR(test.latest()->inTime()->end.depth, 0.001, 0.0001) << "where the press met that force";
    test.setForce(2 * test.force());
    const double chosen = test.force();
    test.chooseKind(TestKind::Press);
    test.setDepth(0.001);
    measure();
    EXPECT_EQ(test.force(), chosen);
}

TEST_F(VirtualTestInTime, EachKindOfTestHasItsOwnResultAndFailure) {
    test.choosePlace(placeIn(5));
    measure();
    const VirtualTest::Press pressed = test.latest();
    ASSERT_TRUE(pressed);
    test.keepLatest();
    test.chooseKind(TestKind::Push);
    EXPECT_FALSE(test.latest());
    EXPECT_FALSE(test.former());
    test.setForce(1e5);
    measure();
    EXPECT_NE(test.failure(), "");
    test.chooseKind(TestKind::Press);
    EXPECT_EQ(test.failure(), "");
    EXPECT_EQ(test.latest(), pressed);
    EXPECT_EQ(test.former(), pressed);
}

TEST_F(VirtualTestInTime, ViscosityCountsForTestsInTimeAlone) {
    test.choosePlace(placeIn(5));
    test.setForce(0.05);
    measure();
    test.chooseKind(TestKind::Push);
    measure();
    const VirtualTest::Press before = test.latest();
    ASSERT_TRUE(before) << test.failure();
    document.edit("dampen", [](Project& project) {
        for (Region& region : project.regions)
            region.held.viscosity = 3 * region.held.viscosity.value_or(5);
    });
    ESM_EVENTUALLY(test.isOutdated());
    measure();
    EXPECT_EQ(test.former(), before);
    EXPECT_FALSE(test.isOutdated());
    test.setForce(1.5 * test.force());
    measure();
    EXPECT_FALSE(test.former()) << "another force says nothing of the tissue";
    test.chooseKind(TestKind::Press);
    EXPECT_FALSE(test.isOutdated()) << "at rest no damper bears anything";
}

} // namespace
