#include "app/editor/window/export_controller.h"

#include "app/editor/window/file_controller.h"
#include "app/editor/workers/poke_test.h"
#include "core/samples/samples.h"
#include "core/support/file_io.h"
#include "tests/app/editor/workers/poked_organ.h"
#include "tests/app/editor_driver.h"
#include "tests/support/stand_in_sofa.h"
#include "tests/support/temporary_folder.h"
#include "widgets/inputs/number_field.h"
#include "widgets/plot/curve_chart.h"

#include <QComboBox>
#include <QLabel>
#include <QRegularExpression>

using namespace esm;

namespace {

class ExportControllerTest : public EditorTest {
protected:
    void SetUp() override { open(makeSample("tube")); }

    TemporaryFolder folder;
    const std::filesystem::path written = folder / "organ.sofa";
};

TEST_F(ExportControllerTest, SaysWhatWillDifferAndAsksHowAnEngineStepsBeforeItWrites) {
    dialogs.expectNamed("exportDialog", [&](QDialog* dialog) {
        EXPECT_FALSE(std::filesystem::exists(written));
        const auto told = [&](const char* label) { return dialog->findChild<QLabel*>(label)->text(); };
        auto* accepting = dialog->findChild<QPushButton*>("exportAccept");
        ESM_EVENTUALLY(accepting->isEnabled());
        EXPECT_TRUE(told("exportDifferences").contains("instruments"));
        EXPECT_TRUE(told("exportSteps").contains("any length"));
        auto* damping = dialog->findChild<QComboBox*>("exportDamping");
        auto* step = dialog->findChild<NumberField*>("exportTimeStep");
        EXPECT_EQ(step->value(), 0.005);
        damping->setCurrentIndex(1);
        ESM_EVENTUALLY(told("exportSteps").contains("not stable"));
        EXPECT_LT(step->value(), 1e-5);
        damping->setCurrentIndex(0);
        ESM_EVENTUALLY(told("exportSteps").contains("any length"));
        EXPECT_EQ(step->value(), 0.005);
        step->selectAll();
        QTest::keyClicks(step, "2");
        QTest::keyClick(step, Qt::Key_Return);
    });
    window->files().exports().exportTo(written);
    const Bytes scene = readFile(written / "organ.scn");
    EXPECT_NE(std::string(scene.begin(), scene.end()).find("dt=\"0.002\""), std::string::npos);
}

/// Who exports before it is known is told first, and one press takes the step that does not blow up.
TEST_F(ExportControllerTest, WarnsOfAStepThatBlowsUpAndOffersTheUsualOne) {
    dialogs.expectNamed("exportDialog", [&](QDialog* dialog) {
        auto* warning = dialog->findChild<QLabel*>("exportPoorStep");
        auto* usual = dialog->findChild<QPushButton*>("exportUsualStep");
        auto* step = dialog->findChild<NumberField*>("exportTimeStep");
        dialog->findChild<QComboBox*>("exportDamping")->setCurrentIndex(1);
        ESM_EVENTUALLY(step->value() && *step->value() < 1e-5);
        EXPECT_FALSE(warning->isVisible());
        const auto usualStep = step->value();
        step->setFocus();
        step->selectAll();
        QTest::keyClicks(step, "5.0");
        QTest::mouseClick(dialog->findChild<QPushButton*>("exportAccept"), Qt::LeftButton);
        ESM_EVENTUALLY(warning->isVisible());
        EXPECT_TRUE(warning->text().contains("blow up")) << warning->text().toStdString();
        usual->click();
        ESM_EVENTUALLY(!warning->isVisible());
        EXPECT_EQ(step->value(), usualStep);
        dialog->reject();
    });
    window->files().exports().exportTo(written);
}

TEST_F(ExportControllerTest, WarnsOfAStepThatIsStableAndTooLong) {
    dialogs.expectNamed("exportDialog", [&](QDialog* dialog) {
        auto* warning = dialog->findChild<QLabel*>("exportPoorStep");
        auto* step = dialog->findChild<NumberField*>("exportTimeStep");
        ESM_EVENTUALLY(step->value());
        EXPECT_FALSE(warning->isVisible());
        step->setFocus();
        step->selectAll();
        QTest::keyClicks(step, "900");
        QTest::keyClick(step, Qt::Key_Return);
        ESM_EVENTUALLY(warning->isVisible());
        EXPECT_TRUE(warning->text().contains("far from that here")) << warning->text().toStdString();
        dialog->findChild<QPushButton*>("exportUsualStep")->click();
        ESM_EVENTUALLY(!warning->isVisible());
        dialog->reject();
    });
    window->files().exports().exportTo(written);
}

/// Who has pressed Export already goes on typing: what is written is what the field shows.
TEST_F(ExportControllerTest, WritesTheStepThatIsTypedWhileItLooks) {
    dialogs.expectNamed("exportDialog", [&](QDialog* dialog) {
        auto* accepting = dialog->findChild<QPushButton*>("exportAccept");
        auto* step = dialog->findChild<NumberField*>("exportTimeStep");
        ESM_EVENTUALLY(accepting->isEnabled());
        dialog->findChild<QComboBox*>("exportRelease")->setCurrentIndex(0);
        accepting->click();
        EXPECT_TRUE(dialog->findChild<QLabel*>("exportDifferences")->text().contains("exporting then"));
        QApplication::setActiveWindow(dialog);
        step->setFocus();
        step->selectAll();
        QTest::keyClicks(step, "3");
    });
    window->files().exports().exportTo(written);
    const Bytes scene = readFile(written / "organ.scn");
    EXPECT_NE(std::string(scene.begin(), scene.end()).find("dt=\"0.003\""), std::string::npos);
}

TEST_F(ExportControllerTest, WritesNothingWhereTheQuestionIsCancelled) {
    dialogs.expectNamed("exportDialog", [](QDialog* dialog) { dialog->reject(); });
    window->files().exports().exportTo(written);
    EXPECT_FALSE(std::filesystem::exists(written));
}

/// Qt's dialog would step into it without a word.
TEST_F(ExportControllerTest, SaysThatAFolderIsThereAlready) {
    std::filesystem::create_directory(written);
    writeFileAtomically(written / "mine.txt", std::string("x"));
    dialogs.expectFile(written);
    QString problem;
    dialogs.expectNamed("problemBox", [&](QDialog* box) {
        problem = qobject_cast<QMessageBox*>(box)->informativeText();
        box->reject();
    });
    window->files().exports().choose();
    EXPECT_TRUE(dialogs.isDone());
    EXPECT_TRUE(problem.contains("organ.sofa")) << problem.toStdString();
    EXPECT_TRUE(std::filesystem::exists(written / "mine.txt"));
}

TEST_F(ExportControllerTest, AsksNothingOfAPackage) {
    window->files().exports().exportTo(folder / "organ.glb");
    EXPECT_TRUE(std::filesystem::exists(folder / "organ.glb"));
}

class ExportToSofaTest : public EditorTest {
protected:
    void look(const std::function<void(QDialog*)>& look) {
        dialogs.expectNamed("exportDialog", [look](QDialog* dialog) {
            look(dialog);
            dialog->reject();
        });
        window->files().exports().exportTo(folder / "organ.sofa");
        EXPECT_TRUE(dialogs.isDone());
    }
    /// Presses the button and answers the dialog that follows.
    void tryIt(const QString& following, const std::function<void(QDialog*)>& answer) {
        dialogs.expectNamed("exportDialog", [](QDialog* dialog) {
            QTimer::singleShot(0, trialIn(dialog), &QPushButton::click);
        });
        dialogs.expectNamed(following, answer);
        look([](QDialog*) {});
    }
    static QPushButton* trialIn(const QDialog* dialog) {
        return dialog->findChild<QPushButton*>("exportTrial");
    }

    TemporaryFolder folder;
};

TEST_F(ExportToSofaTest, SaysWhatToDoWhereSofaIsNotInstalled) {
    const esm::test::WithVariable named("ESM_RUNSOFA", folder / "none");
    open(esm::test::falling(makeSample("tube")));
    look([](QDialog* dialog) {
        EXPECT_FALSE(trialIn(dialog)->isEnabled());
        EXPECT_TRUE(trialIn(dialog)->toolTip().contains("ESM_RUNSOFA"));
    });
}

TEST_F(ExportToSofaTest, SaysWhatToDoWhereNothingMovesTheOrgan) {
    const esm::test::WithVariable named("ESM_RUNSOFA", esm::test::standInSofa());
    open(makeSample("tube"));
    look([](QDialog* dialog) {
        ASSERT_NE(trialIn(dialog), nullptr);
        EXPECT_FALSE(trialIn(dialog)->isEnabled());
        EXPECT_TRUE(trialIn(dialog)->toolTip().contains("record a poke"));
    });
}

/// The stand-in falls, and so stands still here; the scene of the project moves nothing.
TEST_F(ExportToSofaTest, TriesTheRecordedPull) {
    const esm::test::WithVariable named("ESM_RUNSOFA", esm::test::standInSofa());
    open(pokedOrgan());
    auto* poke = window->findChild<PokeTest*>();
    auto* preview = window->findChild<Preview*>();
    poke->record();
    ESM_EVENTUALLY(poke->recordedTime() > 0.1);
    preview->setPull(Pull{40, project().network->restPositions[40] + Eigen::Vector3d(0.02, 0, 0)});
    const double taken = poke->recordedTime();
    ESM_EVENTUALLY(poke->recordedTime() > taken + 0.3);
    poke->stop();
    QString said, motion;
    tryIt("sofaTrialDialog", [&](QDialog* dialog) {
        said = dialog->findChild<CurveChart*>()->spokenValue();
        motion = dialog->findChild<QLabel*>("sofaTrialMotion")->text();
        dialog->reject();
    });
    EXPECT_TRUE(motion.contains("the recorded pull")) << motion.toStdString();
    EXPECT_TRUE(
        QRegularExpression("^here, [0-9.]+ s: [1-9][0-9.]* mm; in SOFA, [0-9.]+ s: 0").match(said).hasMatch())
        << said.toStdString();
}

TEST_F(ExportToSofaTest, ShowsTheMotionHereAndInSofa) {
    const esm::test::WithVariable named("ESM_RUNSOFA", esm::test::standInSofa());
    open(esm::test::falling(makeSample("tube")));
    QString said, motion, error, times;
    tryIt("sofaTrialDialog", [&](QDialog* dialog) {
        said = dialog->findChild<CurveChart*>()->spokenValue();
        motion = dialog->findChild<QLabel*>("sofaTrialMotion")->text();
        error = dialog->findChild<QLabel*>("sofaTrialError")->text();
        times = dialog->findChild<QLabel*>("sofaTrialTimes")->text();
        dialog->reject();
    });
    EXPECT_EQ(said.toStdString(), "here, 0.100 s: 49.1 mm; in SOFA, 0.100 s: 49.1 mm");
    EXPECT_TRUE(motion.contains("the project's scene")) << motion.toStdString();
    EXPECT_TRUE(error.contains("within 1 %")) << error.toStdString();
    EXPECT_TRUE(error.contains("20 times")) << error.toStdString();
    EXPECT_TRUE(times.contains("in SOFA in steps of 5.00 ms")) << times.toStdString();
}

TEST_F(ExportToSofaTest, SaysWhatSofaSaidWhereItFails) {
    const esm::test::WithVariable named("ESM_RUNSOFA", esm::test::standInSofa());
    const esm::test::WithVariable role("SOFA_ROLE", "error");
    open(esm::test::falling(makeSample("tube")));
    QString problem;
    tryIt("problemBox", [&](QDialog* box) {
        problem = qobject_cast<QMessageBox*>(box)->informativeText();
        box->reject();
    });
    EXPECT_TRUE(problem.contains("no such component")) << problem.toStdString();
}

} // namespace
