#include "widgets/fuzzy/term_layout.h"

#include <gmock/gmock.h>

using namespace esm;
using testing::ElementsAre;

TEST(SpreadWords, LeavesWordsThatHaveRoomWhereTheyBelong) {
    EXPECT_THAT(spreadWords({{30, 20}, {80, 10}}, 200, 5), ElementsAre(20, 75));
    EXPECT_THAT(spreadWords({}, 200, 5), ElementsAre());
}

TEST(SpreadWords, PushesCrowdedWordsApartBothWays) {
    EXPECT_THAT(spreadWords({{100, 20}, {110, 20}, {180, 10}}, 200, 6), ElementsAre(82, 108, 175));
}

TEST(SpreadWords, KeepsWithinTheRow) {
    EXPECT_THAT(spreadWords({{0, 20}, {10, 20}, {198, 10}}, 200, 5), ElementsAre(0, 25, 190));
}
