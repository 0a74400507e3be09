#include "core/fuzzy/value_cells.h"

#include <gmock/gmock.h>

#include <cmath>

using namespace esm;
using testing::ElementsAre;
using testing::IsEmpty;

namespace {

std::vector<std::string> gapsOf(const std::vector<Trapezoid>& sets) {
    FuzzyVariable variable{"age", 0, 10, {}};
    for (const Trapezoid& set : sets)
        variable.terms.push_back({"t" + std::to_string(variable.terms.size()), set});
    std::vector<std::string> gaps;
    for (const ValueRange& gap : partitionGaps(variable))
        gaps.push_back(inWords(gap));
    return gaps;
}

} // namespace

TEST(PartitionGaps, AreExactAtTheCorners) {
    EXPECT_THAT(gapsOf({{0, 0, 4, 6}, {4, 6, 10, 10}}), IsEmpty());
    EXPECT_THAT(gapsOf({{0, 0, 3, 4}, {5, 6, 10, 10}}), ElementsAre("from 4 to 5"));
    EXPECT_THAT(gapsOf({{0, 0, 4, 4}, {5, 6, 10, 10}}), ElementsAre("above 4, up to 5"));
    EXPECT_THAT(gapsOf({{0, 0, 3, 4}, {5, 5, 10, 10}}), ElementsAre("from 4 to below 5"));
    EXPECT_THAT(gapsOf({{0, 0, 4, 4}, {5, 5, 10, 10}}), ElementsAre("between 4 and 5"));
    EXPECT_THAT(gapsOf({{0, 0, 3, 5}, {5, 6, 10, 10}}), ElementsAre("exactly 5"));
    EXPECT_THAT(gapsOf({{0, 0, 5, 5}, {5, 5, 10, 10}}), IsEmpty());
    EXPECT_THAT(gapsOf({{0, 5, 5, 10}}), ElementsAre("exactly 0", "exactly 10"));
    EXPECT_THAT(gapsOf({{-3, -2, 1, 2}, {12, 13, 14, 15}}), ElementsAre("from 2 to 10"));
}

TEST(PartitionGaps, AreNotSeenBetweenNumbersThatFollowEachOther) {
    const double next = std::nextafter(5, 6);
    EXPECT_THAT(gapsOf({{0, 0, 5, 5}, {next, next, 10, 10}}), IsEmpty());
}
