#include "core/fuzzy/renamed_words.h"

#include "tests/core/fuzzy/age_and_zeal.h"

#include <gtest/gtest.h>

using namespace esm;

namespace {

FuzzyVariable& age(FuzzySystem& system) {
    return system.inputs[0];
}

} // namespace

TEST(RenamedWords, FollowVariablesAndTheirTermsInWhatCannotBeRead) {
    const FuzzySystem before = ageAndZealSystem();
    FuzzySystem after = before;
    age(after).terms[1].name = "aged";
    after.inputs[1].name = "keenness";
    EXPECT_EQ(withNamesOf(after, before, "  IF(age IS NOT old AND zeal IS much ,"),
              "  IF(age IS NOT aged AND keenness IS much ,");
    EXPECT_EQ(withNamesOf(after, before, "IF old IS old"), "IF old IS old") << "of no variable";
    EXPECT_EQ(withNamesOf(after, before, ""), "");
}

TEST(RenamedWords, ChangePlacesWhereNamesDoStepByStep) {
    FuzzySystem system = ageAndZealSystem();
    std::string line = "IF age IS " + age(system).terms[0].name;
    const std::string other = age(system).terms[1].name;
    const auto rename = [&](std::size_t term, const std::string& name) {
        FuzzySystem after = system;
        age(after).terms[term].name = name;
        line = withNamesOf(after, system, line);
        system = after;
    };
    const std::string first = age(system).terms[0].name;
    rename(0, "between");
    rename(1, first);
    rename(0, other);
    EXPECT_EQ(line, "IF age IS " + other);
}

TEST(RenamedWords, StayWhereTermsAreReorderedAddedOrRemoved) {
    const FuzzySystem before = ageAndZealSystem();
    const std::string line = "IF age IS old";
    FuzzySystem after = before;
    std::swap(age(after).terms[0], age(after).terms[1]);
    EXPECT_EQ(withNamesOf(after, before, line), line);
    after = before;
    age(after).terms.erase(age(after).terms.begin() + 1);
    EXPECT_EQ(withNamesOf(after, before, line), line);
}
