#include "core/fuzzy/normal_form.h"

#include "tests/core/fuzzy/age_and_zeal.h"

#include <gtest/gtest.h>

using namespace esm;

namespace {

bool sameForm(const std::string& one, const std::string& other, const FuzzyNorms& norms = {}) {
    const FuzzySystem system = ageAndZealSystem();
    const auto form = [&](const std::string& condition) {
        return normalForm(parseRule(system, "IF " + condition + " THEN mass IS small").condition, norms);
    };
    return form(one) == form(other);
}

} // namespace

TEST(NormalForm, LooksThroughOrderBracketsAndNot) {
    EXPECT_TRUE(sameForm("age IS old AND zeal IS much", "zeal IS much AND (age IS old)"));
    EXPECT_TRUE(sameForm("age IS old AND NOT NOT (zeal IS much AND age IS young)",
                         "age IS young AND zeal IS much AND age IS old"));
    EXPECT_TRUE(sameForm("NOT (age IS old OR zeal IS much)", "zeal IS NOT much AND age IS NOT old"));
    EXPECT_TRUE(sameForm("age IS old AND age IS old", "age IS old"));
    EXPECT_FALSE(sameForm("age IS old AND zeal IS much", "age IS old OR zeal IS much"));
    EXPECT_FALSE(sameForm("age IS old", "age IS NOT young"));
    EXPECT_FALSE(sameForm("NOT (age IS old OR zeal IS much)", "age IS NOT old OR zeal IS NOT much"));
}

TEST(NormalForm, KeepsWhatTheNormsMakeDifferent) {
    FuzzyNorms norms;
    norms.conjunction = TNorm::Product;
    EXPECT_FALSE(sameForm("age IS old AND age IS old", "age IS old", norms));
    EXPECT_TRUE(sameForm("age IS old OR age IS old", "age IS old", norms));
    EXPECT_FALSE(sameForm("NOT (age IS old OR zeal IS much)", "zeal IS NOT much AND age IS NOT old", norms));
    EXPECT_TRUE(
        sameForm("NOT (age IS old OR zeal IS much)", "NOT (zeal IS much OR NOT NOT age IS old)", norms));
    norms.disjunction = TConorm::ProbabilisticSum;
    EXPECT_TRUE(sameForm("NOT (age IS old OR zeal IS much)", "zeal IS NOT much AND age IS NOT old", norms));
}
