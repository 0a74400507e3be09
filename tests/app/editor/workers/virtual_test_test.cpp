#include "app/editor/workers/virtual_test.h"

#include "tests/app/editor/panels/measure/pressed_organ.h"

#include <gmock/gmock.h>

using namespace esm;

namespace {

class VirtualTestTest : public PressedOrgan {};

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

} // namespace
