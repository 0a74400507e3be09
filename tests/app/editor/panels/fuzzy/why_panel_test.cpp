#include "app/editor/panels/fuzzy/why_panel.h"
#include "core/exchange/fuzzy/fuzzy_file.h"
#include "core/samples/samples.h"
#include "tests/support/eventually.h"
#include "widgets/inputs/number_text.h"

#include <gtest/gtest.h>
#include <QTest>

using namespace esm;

namespace {

Project withSystem(const std::shared_ptr<const FuzzySystem>& system) {
    Project tube = makeSample("tube");
    Region whole;
    whole.name = "whole";
    whole.system = system;
    for (const FuzzyVariable& input : system->inputs)
        whole.inputs.emplace_back(input.name, (input.minimum + input.maximum) / 2);
    tube.regions = {whole};
    return tube;
}

std::shared_ptr<const FuzzySystem> preset(const char* name) {
    return std::make_shared<const FuzzySystem>(fuzzyPreset(name));
}

/// As slow as a system may be: all rules overlap, and what is summed is curved.
std::shared_ptr<const FuzzySystem> slowSystem() {
    FuzzySystem system = fuzzyPreset("robo-sim");
    system.norms.aggregation = TConorm::ProbabilisticSum;
    for (FuzzyVariable* variable : {&system.inputs[0], &system.inputs[1]})
        for (FuzzyTerm& term : variable->terms)
            term.set = {-20, 5, 5, 30};
    const auto rules = system.rules;
    for (std::size_t i = rules.size(); i < mostFuzzyRules; ++i)
        system.rules.push_back(rules[i % 6]);
    return std::make_shared<const FuzzySystem>(system);
}

class WhyPanelTest : public testing::Test {
protected:
    explicit WhyPanelTest(const char* system = "robo-sim")
        : document(withSystem(preset(system))), selection(document), panel(document, selection) {
        selection.setRegion(document.project().regions[0].id);
        panel.resize(316, 760);
        panel.show();
        EXPECT_TRUE(QTest::qWaitForWindowExposed(&panel, patience));
        waitForAnswer();
    }

    void waitForAnswer() {
        ASSERT_TRUE(QTest::qWaitFor([&] { return panel.isUpToDate(); }, patience));
    }
    template<typename Widget> Widget* child(const char* name) { return panel.findChild<Widget*>(name); }
    double input(std::size_t index) { return document.project().regions[0].inputs[index].second; }
    std::optional<double> inferred(std::size_t output) {
        return evaluate(document.project().regions[0], usualWallThickness).inference.outputs[output];
    }

    Document document;
    Selection selection;
    WhyPanel panel;
    ResponseCurveView* curve = child<ResponseCurveView>("responseCurve");
    ResponseMapView* map = child<ResponseMapView>("responseMap");
    RuleStrengths* rules = child<RuleStrengths>("ruleStrengths");
    ConclusionView* conclusion = child<ConclusionView>("conclusionView");
};

} // namespace

TEST_F(WhyPanelTest, FollowsASliderAtOnce) {
    const QString before = conclusion->textAt(std::nullopt);
    EXPECT_EQ(before, QString("centre of gravity %1").arg(withUnit(*inferred(0), "N/m")));
    document.edit("move", [](Project& p) { p.regions[0].inputs[0].second = 7.3; });
    waitForAnswer();
    EXPECT_NE(conclusion->textAt(std::nullopt), before);
    EXPECT_EQ(conclusion->textAt(std::nullopt),
              QString("centre of gravity %1").arg(withUnit(*inferred(0), "N/m")));
    EXPECT_NEAR(curve->outputAt(7.3).value(), *inferred(0), 0.5);
    EXPECT_TRUE(rules->explained(rules->order()[0]).contains("1.00")) << "the strongest stands first";
    EXPECT_TRUE(rules->explained(1).contains("0.80")) << "consistency is hard";
    document.undoStack()->undo();
    waitForAnswer();
    EXPECT_EQ(conclusion->textAt(std::nullopt), before);
}

TEST_F(WhyPanelTest, AClickOnTheCurveSetsTheInputAndCanBeTakenBack) {
    const double before = input(0);
    QTest::mouseClick(curve, Qt::LeftButton, {}, {qRound(curve->frame().x(8)), curve->height() / 2});
    EXPECT_NEAR(input(0), 8, 0.05);
    EXPECT_EQ(document.undoStack()->count(), 1);
    waitForAnswer();
    QTest::keyClick(curve, Qt::Key_Right);
    EXPECT_NEAR(input(0), 8.1, 0.05);
    document.undoStack()->undo();
    EXPECT_NEAR(input(0), 8, 0.05) << "the key was an edit of its own";
    document.undoStack()->undo();
    EXPECT_EQ(input(0), before);
}

TEST_F(WhyPanelTest, QuickKeysLoseNoStep) {
    document.edit("inputs",
                  [](Project& p) { p.regions[0].inputs[0].second = p.regions[0].inputs[1].second = 5; });
    waitForAnswer();
    for (const int key : {Qt::Key_Right, Qt::Key_Right, Qt::Key_Up, Qt::Key_Right})
        QTest::keyClick(map, Qt::Key(key));
    EXPECT_NEAR(input(0), 5.3, 1e-9);
    EXPECT_NEAR(input(1), 5.1, 1e-9);
}

TEST_F(WhyPanelTest, AKeySetsNoOtherInput) {
    document.edit("leave out",
                  [](Project& p) { p.regions[0].inputs.erase(p.regions[0].inputs.begin() + 1); });
    waitForAnswer();
    QTest::keyClick(map, Qt::Key_Right);
    EXPECT_EQ(document.project().regions[0].inputs.size(), 2u);
}

TEST_F(WhyPanelTest, ADragOverTheMapSetsBothInputsInOneEdit) {
    const double across = input(0), up = input(1);
    const PlotFrame frame = map->frame();
    QTest::mousePress(map, Qt::LeftButton, {}, frame.at(2, 8).toPoint());
    EXPECT_NEAR(input(0), 2, 0.1);
    EXPECT_NEAR(input(1), 8, 0.1);
    QMouseEvent move(QEvent::MouseMove, frame.at(3, 6), Qt::NoButton, Qt::LeftButton, {});
    QApplication::sendEvent(map, &move);
    QTest::mouseRelease(map, Qt::LeftButton, {}, frame.at(3, 6).toPoint());
    EXPECT_NEAR(input(0), 3, 0.1);
    EXPECT_NEAR(input(1), 6, 0.1);
    EXPECT_EQ(document.undoStack()->count(), 1);
    waitForAnswer();
    EXPECT_NEAR(map->outputAt(input(0), input(1)).value(), *inferred(0), 2) << "by cells";
    EXPECT_TRUE(map->said().endsWith(": " + withUnit(*inferred(0), "N/m"))) << map->said().toStdString();
    document.undoStack()->undo();
    EXPECT_EQ(input(0), across);
    EXPECT_EQ(input(1), up);
}

TEST_F(WhyPanelTest, AnotherOutputAndAnotherInputCanBeChosen) {
    child<QComboBox>("whyOutput")->setCurrentIndex(1);
    child<QComboBox>("whyAcross")->setCurrentIndex(2);
    waitForAnswer();
    EXPECT_TRUE(conclusion->textAt(std::nullopt).endsWith("N·s/m"));
    EXPECT_NEAR(curve->outputAt(input(2)).value(), *inferred(1), 1);
    child<QComboBox>("whyUp")->setCurrentIndex(2);
    EXPECT_EQ(child<QComboBox>("whyUp")->currentIndex(), 2);
    EXPECT_EQ(child<QComboBox>("whyAcross")->currentIndex(), 1) << "they swap";
}

TEST_F(WhyPanelTest, SaysWhatIsHeld) {
    document.edit("hold", [](Project& p) { p.regions[0].held.springConstant = 5; });
    waitForAnswer();
    EXPECT_TRUE(conclusion->textAt(std::nullopt).startsWith("held at 5.000 N/m"));
}

TEST_F(WhyPanelTest, HasRoomForAllInColumnAndWindow) {
    EXPECT_LE(panel.minimumSizeHint().width(), 316);
    EXPECT_GT(map->geometry().height(), 0);
    EXPECT_EQ(conclusion->mapTo(&panel, QPoint()).x(), rules->mapTo(&panel, QPoint()).x());
    panel.resize(900, 620);
    QTest::qWait(0);
    EXPECT_GT(curve->mapTo(&panel, QPoint()).x(), rules->mapTo(&panel, QPoint(rules->width(), 0)).x());
    EXPECT_EQ(curve->width(), map->width());
    panel.resize(316, 760);
    QTest::qWait(0);
    for (const char* name : {"whyAcross", "whyUp"}) {
        const auto* choice = child<QComboBox>(name);
        EXPECT_GT(choice->width() - 34, choice->fontMetrics().horizontalAdvance("sensitiveness")) << name;
    }
}

TEST_F(WhyPanelTest, AVastSystemDoesNotHoldTheWindowUp) {
    document.replace(withSystem(slowSystem()), std::nullopt);
    selection.setRegion(document.project().regions[0].id);
    EXPECT_FALSE(panel.isUpToDate());
    for (int i = 0; i < 5; ++i)
        document.edit("move", [&](Project& p) { p.regions[0].inputs[2].second = i; });
    QTest::qWait(0);
    EXPECT_FALSE(panel.isUpToDate()) << "no edit waits for the map, which takes far longer";
    document.replace(withSystem(preset("robo-sim")), std::nullopt);
    selection.setRegion(document.project().regions[0].id);
    waitForAnswer();
}

namespace {

class WhyPanelOfOneInputTest : public WhyPanelTest {
protected:
    WhyPanelOfOneInputTest() : WhyPanelTest("susilap-g") {}
};

} // namespace

TEST_F(WhyPanelOfOneInputTest, OffersNoMapAndSaysWhy) {
    EXPECT_FALSE(map->isVisible());
    EXPECT_FALSE(child<QComboBox>("whyUp")->isEnabled());
    EXPECT_TRUE(child<QComboBox>("whyUp")->toolTip().contains("two inputs"));
    EXPECT_NEAR(curve->outputAt(5.5).value(), 16.26, 0.05);
}
