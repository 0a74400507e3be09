#include "widgets/fuzzy/rule_strengths.h"

#include "core/exchange/fuzzy/fuzzy_file.h"
#include "core/fuzzy/inference.h"
#include "tests/support/eventually.h"

#include <gmock/gmock.h>

#include <QSignalSpy>
#include <QTest>

using namespace esm;
using testing::ElementsAre;

namespace {

class RuleStrengthsTest : public testing::Test {
protected:
    RuleStrengthsTest() {
        list.setSystem(system);
        list.resize(300, 200);
        list.show();
        EXPECT_TRUE(QTest::qWaitForWindowExposed(&list, patience));
        explain(5.5);
    }
    void explain(std::optional<double> consistency) {
        list.setExplanations(explainRules(*system, {consistency}));
    }
    void click(int y) { QTest::mouseClick(list.viewport(), Qt::LeftButton, {}, {20, y}); }

    std::shared_ptr<const FuzzySystem> system = std::make_shared<const FuzzySystem>(fuzzyPreset("susilap-g"));
    RuleStrengths list;
    QSignalSpy chosen{&list, &RuleStrengths::ruleChosen};
};

} // namespace

TEST_F(RuleStrengthsTest, TheStrongestStandFirstOrAllInTheirOrder) {
    EXPECT_THAT(list.order(), ElementsAre(0, 6, 1, 2, 3, 4, 5)); // flexible 0.92, medium 0.08
    explain(4.5);
    EXPECT_THAT(list.order(), ElementsAre(6, 0, 1, 2, 3, 4, 5));
    list.setStrongestFirst(false);
    EXPECT_THAT(list.order(), ElementsAre(0, 1, 2, 3, 4, 5, 6));
}

TEST_F(RuleStrengthsTest, TellsHowADegreeComesAbout) {
    EXPECT_EQ(list.explained(6),
              "IF consistency IS medium THEN spring const IS medium AND viscosity IS medium\n"
              "consistency is medium: 0.08\n"
              "It fires to the degree 0.08.");
    explain(std::nullopt);
    EXPECT_TRUE(list.explained(6).contains("left out"));
}

TEST_F(RuleStrengthsTest, ClicksAndKeysChooseARule) {
    click(5);
    EXPECT_EQ(list.chosenRule(), 0U);
    QTest::keyClick(&list, Qt::Key_Down);
    EXPECT_EQ(list.chosenRule(), 6U);
    for (int i = 0; i < 10; ++i)
        QTest::keyClick(&list, Qt::Key_Down);
    EXPECT_EQ(list.chosenRule(), 5U);
    QTest::keyClick(&list, Qt::Key_Escape);
    EXPECT_EQ(list.chosenRule(), std::nullopt);
    click(5);
    click(5);
    EXPECT_EQ(list.chosenRule(), std::nullopt);
    EXPECT_EQ(chosen.count(), 2 + 5 + 1 + 2);
}

TEST_F(RuleStrengthsTest, TheChoiceIsOfARuleNotOfAPlace) {
    click(5);
    const QString description = list.spokenValue();
    explain(4.5);
    EXPECT_EQ(list.spokenValue(), list.explained(0));
    EXPECT_NE(list.spokenValue(), description) << "degrees are others";
    list.setSystem(std::make_shared<const FuzzySystem>(*system));
    EXPECT_EQ(list.chosenRule(), 0U);
    FuzzySystem reordered = *system;
    std::swap(reordered.rules[0], reordered.rules[1]);
    list.setSystem(std::make_shared<const FuzzySystem>(reordered));
    EXPECT_EQ(list.chosenRule(), std::nullopt);
    EXPECT_EQ(list.spokenValue().contains("none chosen"), true);
}

TEST_F(RuleStrengthsTest, TheDegreesAreDrawn) {
    const QImage before = list.grab().toImage();
    explain(4.5);
    EXPECT_NE(list.grab().toImage(), before);
    explain(5.5);
    EXPECT_EQ(list.grab().toImage(), before);
}
