#include "app/editor/panels/fuzzy_choice.h"

#include "core/exchange/fuzzy_file.h"

#include <gtest/gtest.h>
#include <QApplication>
#include <QTest>
#include <QWheelEvent>

using namespace esm;

namespace {

class FuzzyChoiceTest : public testing::Test {
protected:
    void SetUp() override {
        QObject::connect(&choice, &FuzzyChoice::systemChosen,
                         [this](const std::shared_ptr<const FuzzySystem>& system) {
                             chosen = system;
                             ++times;
                         });
    }
    void activate(const QString& text) {
        choice.setCurrentIndex(choice.findText(text));
        emit choice.activated(choice.currentIndex());
    }

    const std::string preset = fuzzyPresetNames().front();
    FuzzyChoice choice;
    std::shared_ptr<const FuzzySystem> chosen;
    int times = 0;
};

} // namespace

TEST_F(FuzzyChoiceTest, ChoosesAPresetOnce) {
    activate(QString::fromStdString(preset));
    ASSERT_TRUE(chosen);
    EXPECT_EQ(chosen->name, preset);
    choice.setSystem(chosen);
    EXPECT_EQ(choice.currentText().toStdString(), preset);
    activate(QString::fromStdString(preset));
    EXPECT_EQ(times, 1);
}

TEST_F(FuzzyChoiceTest, AFilesSystemIsNotTakenForThePresetOfItsName) {
    FuzzySystem own = fuzzyPreset(preset);
    own.inputs[0].maximum += 1;
    choice.setSystem(std::make_shared<const FuzzySystem>(own));
    EXPECT_EQ(choice.currentText(), QString::fromStdString(preset) + " (from file)");
    activate(QString::fromStdString(preset));
    ASSERT_TRUE(chosen) << "the preset can be chosen";
    EXPECT_EQ(chosen->inputs[0].maximum, own.inputs[0].maximum - 1);
}

TEST_F(FuzzyChoiceTest, TheWheelLeavesItAlone) {
    choice.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&choice));
    QApplication::setActiveWindow(&choice);
    choice.setFocus();
    QWheelEvent event({5, 5}, choice.mapToGlobal(QPoint(5, 5)), {}, {0, -120}, Qt::NoButton, Qt::NoModifier,
                      Qt::NoScrollPhase, false);
    QApplication::sendEvent(&choice, &event);
    EXPECT_EQ(choice.currentIndex(), 0);
    EXPECT_EQ(times, 0);
}
