#include "app/editor/panels/fuzzy/fuzzy_choice.h"

#include "core/exchange/fuzzy/fuzzy_file.h"
#include "core/support/file_io.h"
#include "tests/app/editor_driver.h"
#include "tests/support/temporary_folder.h"

#include <nlohmann/json.hpp>
#include <QSignalSpy>
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

    const std::string preset = "robo-sim"; // which every language can say
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
    EXPECT_EQ(choice.shownName(), QString::fromStdString(preset) + " (changed)");
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

TEST_F(FuzzyChoiceTest, StaysFilledWhileACornerIsDragged) {
    FuzzySystem own = fuzzyPreset(preset);
    const auto drag = [&] {
        own.inputs[0].terms[0].set.d += 0.1;
        choice.setSystem(std::make_shared<const FuzzySystem>(own));
    };
    drag();
    QSignalSpy filled(choice.model(), &QAbstractItemModel::rowsInserted);
    drag();
    EXPECT_EQ(filled.count(), 0);
    EXPECT_EQ(choice.shownName(), QString::fromStdString(preset) + " (changed)");
    choice.setSystem(std::make_shared<const FuzzySystem>(fuzzyPreset(preset)));
    EXPECT_GT(filled.count(), 0);
    EXPECT_EQ(choice.shownName(), QString::fromStdString(preset));
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

TEST_F(FuzzyChoiceTest, OpensOtherLanguagesAndTellsWhatWasNotTaken) {
    QApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
    const TemporaryFolder folder;
    std::string text = exportFuzzySystem(fuzzyPreset(preset), "a.fll").text;
    text.replace(text.find("Centroid"), 8, "Bisector");
    writeFileAtomically(folder / "own.fll", text);
    writeFileAtomically(folder / "own.fcl", exportFuzzySystem(fuzzyPreset(preset), "a.fcl").text);
    DialogScript dialogs;
    dialogs.expectFile(folder / "own.fll");
    dialogs.expectNamed("remarkBox", [](QDialog* box) {
        EXPECT_TRUE(qobject_cast<QMessageBox*>(box)->informativeText().contains("Bisector"));
        box->accept();
    });
    activate("From file");
    EXPECT_TRUE(dialogs.isDone());
    EXPECT_EQ(times, 1);
    dialogs.expectFile(folder / "own.fcl");
    activate("From file");
    EXPECT_EQ(times, 2);
    EXPECT_EQ(chosen->rules.size(), fuzzyPreset(preset).rules.size());
}

TEST_F(FuzzyChoiceTest, AFileThatCannotBeReadChangesNothing) {
    QApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
    const TemporaryFolder folder;
    writeFileAtomically(folder / "broken.fcl", std::string("FUNCTION_BLOCK x\nVAR_INPUT\n"));
    DialogScript dialogs;
    dialogs.expectFile(folder / "broken.fcl");
    dialogs.expectNamed("problemBox", [](QDialog* box) {
        EXPECT_TRUE(qobject_cast<QMessageBox*>(box)->informativeText().contains("line 3, column 1"));
        box->accept();
    });
    activate("From file");
    EXPECT_TRUE(dialogs.isDone());
    EXPECT_EQ(times, 0);
}

TEST_F(FuzzyChoiceTest, SavesTheSystemInUseAsTheNameSays) {
    QApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
    const TemporaryFolder folder;
    EXPECT_EQ(choice.findText("Save system", Qt::MatchStartsWith), -1) << "there is nothing to save";
    choice.setSystem(std::make_shared<const FuzzySystem>(fuzzyPreset(preset)));
    DialogScript dialogs;
    for (const char* name : {"own.json", "own.FCL", "own.fll"}) {
        dialogs.expectFile(folder / name);
        activate("Save system");
        EXPECT_EQ(choice.shownName().toStdString(), preset);
        EXPECT_EQ(toJson(importFuzzyFile(folder / name).system), toJson(fuzzyPreset(preset))) << name;
    }
    EXPECT_EQ(times, 0) << "saving is no edit";
}

TEST_F(FuzzyChoiceTest, ANameWithoutEndingGetsTheChosenLanguages) {
    QApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
    const TemporaryFolder folder;
    choice.setSystem(std::make_shared<const FuzzySystem>(fuzzyPreset(preset)));
    DialogScript dialogs;
    dialogs.expect([](QWidget* dialog) { return qobject_cast<QFileDialog*>(dialog) != nullptr; },
                   [&](QDialog* dialog) {
                       auto* files = qobject_cast<QFileDialog*>(dialog);
                       files->selectNameFilter(files->nameFilters().at(1));
                       auto* name = dialog->findChild<QLineEdit*>("fileNameEdit");
                       name->setText(QString::fromStdString((folder / "own").string()));
                       QTest::keyClick(name, Qt::Key_Return);
                   });
    activate("Save system");
    EXPECT_TRUE(std::filesystem::exists(folder / "own.fcl"));
}

TEST_F(FuzzyChoiceTest, TheWheelLeavesItAlone) {
    choice.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&choice, patience));
    QApplication::setActiveWindow(&choice);
    choice.setFocus();
    QWheelEvent event({5, 5}, choice.mapToGlobal(QPoint(5, 5)), {}, {0, -120}, Qt::NoButton, Qt::NoModifier,
                      Qt::NoScrollPhase, false);
    QApplication::sendEvent(&choice, &event);
    EXPECT_EQ(choice.currentIndex(), 0);
    EXPECT_EQ(times, 0);
}
