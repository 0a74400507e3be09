#include "core/fuzzy/partition_edits.h"

#include "core/support/errors.h"

#include <gmock/gmock.h>

#include <cmath>
#include <random>

using namespace esm;
using testing::HasSubstr;
using testing::ThrowsMessage;

namespace {

FuzzyVariable firmness() {
    return {
        "firmness", 0, 12, {{"soft", {0, 0, 2, 3}}, {"medium", {2, 3, 4, 6}}, {"firm", {5, 8, 12, 12}}}, "N"};
}

bool isOrdered(const FuzzyVariable& variable, const Trapezoid& set) {
    return variable.minimum <= set.a && set.a <= set.b && set.b <= set.c && set.c <= set.d &&
           set.d <= variable.maximum;
}

/// Degrees of all terms together.
double sumAt(const FuzzyVariable& variable, const std::vector<FuzzyTerm>& terms, double share) {
    double sum = 0;
    for (const FuzzyTerm& term : terms)
        sum += membership(term.set, variable.minimum + share * (variable.maximum - variable.minimum));
    return sum;
}

/// Of random sets, some of them out of the range.
FuzzyVariable randomPartition(std::mt19937& random) {
    std::uniform_real_distribution<double> place(-3, 13);
    FuzzyVariable variable{"v", 0, 10, {}};
    const std::size_t count = 1 + random() % 6;
    for (std::size_t i = 0; i < count; ++i) {
        std::array<double, 4> corner{place(random), place(random), place(random), place(random)};
        std::sort(corner.begin(), corner.end());
        variable.terms.push_back({"t" + std::to_string(i), {corner[0], corner[1], corner[2], corner[3]}});
    }
    return variable;
}

} // namespace

TEST(PartitionEdits, ACornerGoesNoFurtherThanItsNeighboursAndTheRange) {
    const FuzzyVariable variable = firmness();
    EXPECT_EQ(withCorner(variable, 1, Corner::B, 3.5), (Trapezoid{2, 3.5, 4, 6}));
    EXPECT_EQ(withCorner(variable, 1, Corner::B, 9), (Trapezoid{2, 4, 4, 6}));
    EXPECT_EQ(withCorner(variable, 1, Corner::A, -9), (Trapezoid{0, 3, 4, 6}));
    EXPECT_EQ(withCorner(variable, 1, Corner::D, 99), (Trapezoid{2, 3, 4, 12}));
    EXPECT_EQ(withCorner(variable, 1, Corner::D, 0), (Trapezoid{2, 3, 4, 4}));
}

TEST(PartitionEdits, CornersNeverCrossHoweverTheyAreDragged) {
    std::mt19937 random(4);
    std::uniform_real_distribution<double> place(-20, 40);
    FuzzyVariable variable = firmness();
    for (int i = 0; i < 3000; ++i) {
        const std::size_t term = random() % 3;
        const double value = snapped(variable, term, place(random), {0.3, i % 2 ? 0.1 : 0});
        Trapezoid& set = variable.terms[term].set;
        set = i % 5 ? withCorner(variable, term, everyCorner[random() % 4], value)
                    : shifted(variable, term, value);
        ASSERT_TRUE(isOrdered(variable, set));
    }
}

TEST(PartitionEdits, ACornerBeyondTheRangeMayComeBack) {
    FuzzyVariable variable = firmness();
    variable.terms[2].set = {13, 14, 15, 16};
    EXPECT_EQ(withCorner(variable, 2, Corner::A, 11), (Trapezoid{11, 14, 15, 16}));
    EXPECT_EQ(withCorner(variable, 2, Corner::B, 2), (Trapezoid{13, 13, 15, 16}));
    EXPECT_EQ(withCorner(variable, 2, Corner::D, 99), (Trapezoid{13, 14, 15, 16}));
}

TEST(PartitionEdits, ATermIsShiftedAsAWholeAndShouldersStay) {
    const FuzzyVariable variable = firmness();
    EXPECT_EQ(shifted(variable, 1, 2), (Trapezoid{4, 5, 6, 8}));
    EXPECT_EQ(shifted(variable, 1, -9), (Trapezoid{0, 1, 2, 4}));
    EXPECT_EQ(shifted(variable, 0, 1), (Trapezoid{0, 0, 3, 4}));
    EXPECT_EQ(shifted(variable, 2, -1), (Trapezoid{4, 7, 12, 12}));
    EXPECT_EQ(shifted(variable, 2, 99), (Trapezoid{9, 12, 12, 12}));
}

TEST(PartitionEdits, ASinglePointAtAnEndOfTheRangeIsNoShoulder) {
    const FuzzyVariable variable{"v", 0, 10, {{"none", {0, 0, 0, 0}}, {"all", {10, 10, 10, 10}}}};
    EXPECT_EQ(shifted(variable, 0, 2), (Trapezoid{2, 2, 2, 2}));
    EXPECT_EQ(shifted(variable, 0, -2), (Trapezoid{0, 0, 0, 0}));
    EXPECT_EQ(shifted(variable, 1, -3), (Trapezoid{7, 7, 7, 7}));
    EXPECT_EQ(withRange(variable, -5, 20, TermsInRange::Stay).terms, variable.terms);
    EXPECT_EQ(withRange(variable, 20, 30, TermsInRange::Stretch).terms[1].set, (Trapezoid{30, 30, 30, 30}));
    EXPECT_THAT([&] { withRange(variable, 0, 9, TermsInRange::Stay); },
                ThrowsMessage<InvalidModel>(HasSubstr("\"all\" would lie outside 0 to 9")));
}

TEST(PartitionEdits, ACornerSnapsToOtherTermsThenToRoundValues) {
    const FuzzyVariable variable = firmness();
    EXPECT_EQ(snapped(variable, 1, 5.13, {0.2, 0.1}), 5) << "where firm begins";
    EXPECT_EQ(snapped(variable, 1, 11.9, {0.2, 0.1}), 12) << "the end of the range";
    EXPECT_EQ(snapped(variable, 1, 4.08, {0.2, 0.5}), 4) << "not its own corner, but a round value";
    EXPECT_EQ(snapped(variable, 1, 6.94, {0.2, 0.1}), 6.9);
    EXPECT_EQ(snapped(variable, 1, 0.31, {0.2, 0.1}), 0.3) << "as it is written";
    EXPECT_EQ(snapped(variable, 1, 6.94, {0, 0}), 6.94);
}

TEST(PartitionEdits, StepsAreRound) {
    EXPECT_DOUBLE_EQ(roundStep(0.08), 0.1);
    EXPECT_DOUBLE_EQ(roundStep(0.1), 0.1);
    EXPECT_DOUBLE_EQ(roundStep(0.11), 0.2);
    EXPECT_DOUBLE_EQ(roundStep(3), 5);
    EXPECT_DOUBLE_EQ(roundStep(700), 1000);
    EXPECT_DOUBLE_EQ(roundStep(2e-7), 2e-7);
}

TEST(PartitionEdits, AnEvenPartitionHasEqualCoresAndFlanks) {
    const FuzzyVariable variable = firmness();
    const auto terms = evenPartition(variable);
    ASSERT_EQ(terms.size(), 3U);
    EXPECT_EQ(terms[0].set, (Trapezoid{0, 0, 12.0 / 5, 24.0 / 5}));
    EXPECT_EQ(terms[1].set.b - terms[1].set.a, 12.0 / 5);
    EXPECT_EQ(terms[2].set.c, 12);
    EXPECT_EQ(terms[2].set.d, 12);
    EXPECT_EQ(terms[1].name, "medium");
    for (double share = 0; share <= 1; share += 1.0 / 64)
        EXPECT_NEAR(sumAt(variable, terms, share), 1, 1e-12);
    const auto one = evenPartition({"v", 2, 3, {{"all", {}}}});
    EXPECT_EQ(one[0].set, (Trapezoid{2, 2, 3, 3}));
}

TEST(PartitionEdits, OverlappingByHalfKeepsWhatCoversOnce) {
    FuzzyVariable variable = firmness();
    variable.terms = overlappedByHalf(variable);
    EXPECT_EQ(variable.terms[0].set, (Trapezoid{0, 0, 2, 3}));
    EXPECT_EQ(variable.terms[1].set, (Trapezoid{2, 3, 4, 8})) << "its end lies over the next one's beginning";
    EXPECT_EQ(variable.terms[2].set, (Trapezoid{4, 8, 12, 12}));
    EXPECT_EQ(overlappedByHalf(variable), variable.terms);
}

TEST(PartitionEdits, DegreesAddUpToOneAfterOverlappingByHalf) {
    std::mt19937 random(11);
    int overlapped = 0;
    for (int i = 0; i < 500; ++i) {
        const FuzzyVariable variable = randomPartition(random);
        try {
            const auto terms = overlappedByHalf(variable);
            ++overlapped;
            for (double share = 0; share <= 1; share += 1.0 / 37)
                ASSERT_NEAR(sumAt(variable, terms, share), 1, 1e-9) << i;
            for (const FuzzyTerm& term : terms)
                ASSERT_TRUE(isOrdered(variable, term.set));
        } catch (const InvalidModel& error) {
            EXPECT_THAT(error.what(), HasSubstr("at the same place"));
        }
    }
    EXPECT_GT(overlapped, 300);
    FuzzyVariable touching{"v", 0, 10, {{"a", {0, 0, 6, 6}}, {"b", {6, 6, 6, 6}}}};
    touching.terms = overlappedByHalf(touching);
    for (double share = 0; share <= 1; share += 1.0 / 37)
        EXPECT_NEAR(sumAt(touching, touching.terms, share), 1, 1e-12);
}

TEST(PartitionEdits, ShouldersGoWithTheEndsOfTheRange) {
    const FuzzyVariable wider = withRange(firmness(), -2, 20, TermsInRange::Stay);
    EXPECT_EQ(wider.terms[0].set, (Trapezoid{-2, -2, 2, 3}));
    EXPECT_EQ(wider.terms[1].set, firmness().terms[1].set);
    EXPECT_EQ(wider.terms[2].set, (Trapezoid{5, 8, 20, 20}));
    const FuzzyVariable narrower = withRange(firmness(), 1, 5.5, TermsInRange::Stay);
    EXPECT_EQ(narrower.terms[1].set, (Trapezoid{2, 3, 4, 5.5}));
    EXPECT_EQ(narrower.maximum, 5.5);
    EXPECT_EQ(narrower.unit, "N");
}

TEST(PartitionEdits, ARangeThatLeavesATermOutIsRefused) {
    EXPECT_THAT([] { withRange(firmness(), 6.5, 12, TermsInRange::Stay); },
                ThrowsMessage<InvalidModel>(HasSubstr("\"soft\" would lie outside 6.5 to 12")));
    EXPECT_THAT([] { withRange(firmness(), 3, 3, TermsInRange::Stay); },
                ThrowsMessage<InvalidModel>(HasSubstr("the range must rise")));
}

TEST(PartitionEdits, TermsStretchWithTheRange) {
    const FuzzyVariable stretched = withRange(firmness(), 10, 130, TermsInRange::Stretch);
    EXPECT_EQ(stretched.terms[0].set, (Trapezoid{10, 10, 30, 40}));
    EXPECT_EQ(stretched.terms[2].set, (Trapezoid{60, 90, 130, 130}));
    const FuzzyVariable odd = withRange(firmness(), 0.1, 0.7, TermsInRange::Stretch);
    EXPECT_EQ(odd.terms[2].set.d, 0.7) << "met exactly";
}
