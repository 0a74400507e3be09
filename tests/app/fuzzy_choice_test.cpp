#include "app/editor/panels/fuzzy_choice.h"

#include "core/exchange/fuzzy_file.h"
#include "core/support/file_io.h"
#include "tests/app/editor_driver.h"
#include "tests/support/temporary_folder.h"

#include <nlohmann/json.hpp>
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
        choice.setCurrentIndex(choice.findText(text, Qt::MatchStartsWith));
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
    EXPECT_EQ(choice.shownName().toStdString(), preset);
    activate(QString::fromStdString(preset));
    EXPECT_EQ(times, 1);
}

TEST_F(FuzzyChoiceTest, AFilesSystemIsNotTakenForThePresetOfItsName) {
    FuzzySystem own = fuzzyPreset(preset);
    own.inputs[0].maximum += 1;
    choice.setSystem(std::make_shared<const FuzzySystem>(own));
    EXPECT_EQ(choice.shownName(), QString::fromStdString(preset) + " (from file)");
    activate(QString::fromStdString(preset));
    ASSERT_TRUE(chosen) << "the preset can be chosen";
    EXPECT_EQ(chosen->inputs[0].maximum, own.inputs[0].maximum - 1);
}

TEST_F(FuzzyChoiceTest, SaysWhatThereIsToChoose) {
    EXPECT_TRUE(choice.description().contains("words")) << "what a fuzzy system is";
    const FuzzySystem system = fuzzyPreset(preset);
    ASSERT_FALSE(system.description.empty());
    const int row = choice.findText(QString::fromStdString(preset), Qt::MatchStartsWith);
    EXPECT_TRUE(choice.itemText(row).contains(QString::fromStdString(system.inputs[0].name)));
    EXPECT_TRUE(choice.itemData(row, Qt::ToolTipRole)
                    .toString()
                    .startsWith(QString::fromStdString(system.description)));
    choice.setSystem(std::make_shared<const FuzzySystem>(system));
    EXPECT_EQ(choice.description().toStdString(), system.description);
}

TEST_F(FuzzyChoiceTest, KnowsThePresetThatAnOlderProgramSaved) {
    FuzzySystem old = fuzzyPreset(preset);
    old.description.clear();
    choice.setSystem(std::make_shared<const FuzzySystem>(old));
    EXPECT_EQ(choice.shownName().toStdString(), preset);
    EXPECT_EQ(choice.description().toStdString(), fuzzyPreset(preset).description);
}

TEST_F(FuzzyChoiceTest, StartsWhereTheLastFuzzySystemWas) {
    QApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
    const TemporaryFolder folder;
    writeFileAtomically(folder / "own.json", toJson(fuzzyPreset(preset)).dump());
    DialogScript dialogs;
    dialogs.expectFile(folder / "own.json");
    activate("From file");
    ASSERT_TRUE(chosen);
    dialogs.expect([](QWidget* dialog) { return qobject_cast<QFileDialog*>(dialog) != nullptr; },
                   [&](QDialog* dialog) {
                       EXPECT_EQ(qobject_cast<QFileDialog*>(dialog)->directory().path().toStdString(),
                                 folder.path().string());
                       dialog->reject();
                   });
    activate("From file");
    EXPECT_TRUE(dialogs.isDone());
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
