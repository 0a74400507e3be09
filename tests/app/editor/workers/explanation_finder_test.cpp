#include "app/editor/workers/explanation_finder.h"

#include "core/exchange/fuzzy/fuzzy_file.h"
#include "core/fuzzy/inference.h"

#include <gtest/gtest.h>
#include <QTest>

using namespace esm;

namespace {

constexpr int finderPatience = 60000; // ms

class ExplanationFinderTest : public testing::Test {
protected:
    WhyQuestion at(double consistency, double sensitiveness) const {
        return {system, {0, {consistency, sensitiveness, 5.0}}, 0, 1};
    }
    void waitFor(int number) {
        ASSERT_TRUE(QTest::qWaitFor([&] { return finder.answer().complete == number; }, finderPatience));
    }

    std::shared_ptr<const FuzzySystem> system = std::make_shared<const FuzzySystem>(fuzzyPreset("robo-sim"));
    ExplanationFinder finder;
};

} // namespace

TEST_F(ExplanationFinderTest, AnswersAllPartsOfTheLatestQuestion) {
    finder.ask(at(1, 9));
    const WhyQuestion latest = at(7, 3);
    const int number = finder.ask(latest);
    waitFor(number);
    const WhyAnswer answer = finder.answer();
    EXPECT_EQ(answer.explained, number);
    EXPECT_EQ(answer.drawn, number);
    EXPECT_EQ(answer.mapped, number);
    EXPECT_EQ(answer.failed, 0);
    EXPECT_EQ(answer.inputs, latest.point.inputs);
    EXPECT_EQ(answer.rules.size(), system->rules.size());
    EXPECT_EQ(answer.output.value, infer(*system, latest.point.inputs).outputs[0]);
    EXPECT_FALSE(answer.curve->empty());
    EXPECT_EQ(answer.map->cells, 64U);
}

TEST_F(ExplanationFinderTest, DrawsNothingAnewThatIsTheSame) {
    waitFor(finder.ask(at(7, 3)));
    const WhyAnswer before = finder.answer();
    waitFor(finder.ask(at(6, 3)));
    EXPECT_EQ(finder.answer().curve, before.curve) << "it goes over the input that moved";
    EXPECT_EQ(finder.answer().map, before.map);
    waitFor(finder.ask(at(6, 4)));
    EXPECT_NE(finder.answer().curve, before.curve);
    EXPECT_EQ(finder.answer().map, before.map);
}

TEST_F(ExplanationFinderTest, NeedsNoMap) {
    WhyQuestion question = at(7, 3);
    question.up.reset();
    waitFor(finder.ask(question));
    EXPECT_EQ(finder.answer().map, nullptr);
}
