#include "app/editor/panels/measure/accuracy_view.h"
#include "core/authoring/accuracy.h"
#include "core/samples/samples.h"
#include "core/support/file_io.h"
#include "tests/app/editor_driver.h"
#include "tests/support/eventually.h"
#include "tests/support/temporary_folder.h"

#include <gmock/gmock.h>

#include <QTest>

using namespace esm;

namespace {

/// The tube with what might have been measured: two runs that none beats, a poor one, one that ran wild, one
/// that is fast and no better than rest, one left out.
class AccuracyViewTest : public testing::Test {
protected:
    AccuracyViewTest()
        : m_document(makeSample("tube")), m_accuracy(m_document, m_preview), m_view(m_document, m_accuracy) {
        m_view.resize(900, 320);
        m_view.show();
        EXPECT_TRUE(QTest::qWaitForWindowExposed(&m_view, patience));
    }

    void measure() {
        Tradeoff measured;
        const auto run = [&](Integrator integrator, double error, double wall) {
            const Stepping stepping{integrator, 0.01, Precision::Double};
            measured.runs.push_back({stepping,
                                     m_document.project().network->restPositions.size(),
                                     wall > 0,
                                     error,
                                     false,
                                     wall,
                                     {}});
        };
        measured.reference.stepping = {Integrator::Rk4, 1e-5, Precision::Double};
        run(Integrator::Split2, 1e-3, 0.5);
        run(Integrator::Split, 1e-2, 0.1);
        run(Integrator::Bdf2, 1e-1, 2);
        run(Integrator::Euler, 0, 0);
        run(Integrator::Verlet, 1.4, 0.01);
        measured.leftOut = {{{Integrator::Heun, 0.001, Precision::Double}, 7, "would take too long"}};
        m_document.edit("measure", [&](Project& project) {
            project.accuracy = std::make_shared<const MeasuredAccuracy>(
                measuredAccuracy(measuredOrgan(project), detailOf(*project.network), measured));
        });
    }

    AccuracyChart& chart() { return *m_view.findChild<AccuracyChart*>(); }
    RunsTable& table() { return *m_view.findChild<RunsTable*>(); }
    QPushButton& button(const QString& text) {
        for (auto* found : m_view.findChildren<QPushButton*>())
            if (found->text() == text) return *found;
        throw std::out_of_range(text.toStdString());
    }
    QStringList column(int column) {
        QStringList texts;
        for (int row = 0; row < table().model()->rowCount(); ++row)
            texts << table().model()->index(row, column).data().toString();
        return texts;
    }
    std::optional<Integrator> inUse() {
        const auto& stepping = m_document.project().stepping;
        return stepping ? std::optional(stepping->stepping.integrator) : std::nullopt;
    }

    Document m_document;
    Preview m_preview;
    SpeedAndAccuracy m_accuracy;
    AccuracyView m_view;
};

TEST_F(AccuracyViewTest, SaysThatNothingIsMeasuredYet) {
    EXPECT_EQ(table().model()->rowCount(), 0);
    for (const char* name : {"Use", "Save table…", "Save chart…"}) {
        EXPECT_FALSE(button(name).isEnabled());
        EXPECT_EQ(button(name).toolTip(), "Nothing is measured yet");
    }
}

TEST_F(AccuracyViewTest, ListsTheFastestFirstAndLastWhatRanWildOrWasLeftOut) {
    measure();
    EXPECT_EQ(column(RunsModel::Speed), (QStringList{"100×", "10×", "2.0×", "0.50×", "–", "–"}));
    EXPECT_EQ(column(RunsModel::Error).mid(4), (QStringList{"ran wild", "left out"}));
    table().sortByColumn(RunsModel::Error, Qt::AscendingOrder);
    EXPECT_EQ(column(RunsModel::Error),
              (QStringList{"0.10 %", "1.0 %", "10 %", "140 %", "ran wild", "left out"}));
    m_view.findChild<QCheckBox*>()->click();
    EXPECT_EQ(column(RunsModel::Error), (QStringList{"0.10 %", "1.0 %"}));
}

TEST_F(AccuracyViewTest, MarksInOneWhatIsMarkedInTheOther) {
    measure();
    QTest::mouseClick(chart().canvas(), Qt::LeftButton, {}, chart().placeOf(2));
    EXPECT_EQ(table().marked(), 2U);
    EXPECT_FALSE(inUse()) << "to mark is not to choose";
    QTest::keyClick(&table(), Qt::Key_Home, Qt::ControlModifier);
    EXPECT_EQ(table().marked(), 4U) << "the fastest";
    EXPECT_FALSE(button("Use").isEnabled()) << "which shows nothing";
    QTest::keyClick(&table(), Qt::Key_Down);
    EXPECT_EQ(table().marked(), 1U);
    EXPECT_TRUE(button("Use").isEnabled());
    table().mark(3);
    EXPECT_FALSE(button("Use").isEnabled());
    EXPECT_TRUE(button("Use").toolTip().contains("ran wild"));
}

TEST_F(AccuracyViewTest, MarksInTheChartWhatTheTableDoesNotList) {
    measure();
    m_view.findChild<QCheckBox*>()->click();
    QTest::mouseClick(chart().canvas(), Qt::LeftButton, {}, chart().placeOf(2));
    EXPECT_FALSE(table().marked()) << "a poor run has no row";
    EXPECT_TRUE(button("Use").isEnabled());
    button("Use").click();
    EXPECT_EQ(inUse(), Integrator::Bdf2);
    // From a point without a row the arrow keys go on: from 0.5 to 2 and 10 times real time.
    for (const std::size_t next : {0U, 1U}) {
        QTest::keyClick(&chart(), Qt::Key_Right);
        EXPECT_EQ(table().marked(), next);
    }
    QTest::keyClick(&chart(), Qt::Key_Left);
    QTest::keyClick(&chart(), Qt::Key_Left);
    EXPECT_FALSE(table().marked());
    m_view.findChild<QCheckBox*>()->click();
    EXPECT_EQ(table().marked(), 2U) << "it is listed again";
}

TEST_F(AccuracyViewTest, SaysInSightWhyARowWasLeftOut) {
    measure();
    const auto& title = *m_view.findChild<ElidedLabel*>();
    EXPECT_EQ(title.text(), "Every method and step: 5 measured, 1 left out");
    table().mark(5);
    EXPECT_EQ(title.text(), "Left out: would take too long");
    EXPECT_FALSE(button("Use").isEnabled());
    QTest::keyClick(&table(), Qt::Key_Return);
    EXPECT_FALSE(inUse());
    table().mark(0);
    EXPECT_EQ(title.text(), "Every method and step: 5 measured, 1 left out");
}

TEST_F(AccuracyViewTest, ChoosesByButtonKeyAndDoubleClickOneStepEach) {
    measure();
    table().mark(1);
    button("Use").click();
    EXPECT_EQ(inUse(), Integrator::Split);
    table().mark(0);
    QTest::keyClick(&table(), Qt::Key_Return);
    EXPECT_EQ(inUse(), Integrator::Split2);
    QTest::mouseDClick(chart().canvas(), Qt::LeftButton, {}, chart().placeOf(2));
    EXPECT_EQ(inUse(), Integrator::Bdf2);
    table().mark(3);
    QTest::keyClick(&table(), Qt::Key_Return);
    EXPECT_EQ(inUse(), Integrator::Bdf2) << "what ran wild is not chosen";
    for (const std::optional<Integrator> before :
         {std::optional(Integrator::Split2), std::optional(Integrator::Split)}) {
        m_document.undoStack()->undo();
        EXPECT_EQ(inUse(), before);
    }
    m_document.undoStack()->undo();
    EXPECT_FALSE(inUse());
    EXPECT_EQ(table().model()->rowCount(), 6);
    m_document.undoStack()->undo();
    EXPECT_EQ(table().model()->rowCount(), 0);
}

TEST_F(AccuracyViewTest, SavesTheTableAndTheChart) {
    QApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
    measure();
    const TemporaryFolder folder;
    const auto save = [&](const char* what, const char* name) {
        DialogScript dialogs;
        dialogs.expectFile(folder / name);
        button(what).click();
        EXPECT_TRUE(dialogs.isDone());
        const Bytes bytes = readFile(folder / name);
        return std::string(bytes.begin(), bytes.end());
    };
    EXPECT_THAT(save("Save table…", "runs.csv"), testing::HasSubstr("\nsplit2,double,0.01,"));
    EXPECT_THAT(save("Save chart…", "chart.png"), testing::StartsWith("\x89PNG"));
    EXPECT_THAT(save("Save chart…", "chart.SVG"), testing::HasSubstr(">viscous split, second order<"));
}

} // namespace
