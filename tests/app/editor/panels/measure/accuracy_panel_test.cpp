#include "app/editor/panels/measure/accuracy_panel.h"
#include "core/model/tissue_digest.h"
#include "core/project/simulated_network.h"
#include "core/samples/samples.h"
#include "core/support/errors.h"
#include "tests/support/eventually.h"
#include "tests/support/tissue_models.h"

#include <gmock/gmock.h>

#include <QElapsedTimer>
#include <QProgressDialog>
#include <QTest>
#include <QTimer>

using namespace esm;

namespace {

class AccuracyPanelTest : public testing::Test {
protected:
    AccuracyPanelTest()
        : m_document(briefTube()), m_accuracy(m_document, m_preview), m_panel(m_document, m_accuracy) {
        QObject::connect(&m_document, &Document::changed, &m_preview,
                         [this] { m_preview.setProject(m_document.project()); });
        m_preview.setProject(m_document.project());
        m_panel.resize(276, 700);
        m_panel.show();
        EXPECT_TRUE(QTest::qWaitForWindowExposed(&m_panel, patience));
    }

    static Project briefTube() {
        Project tube = makeSample("tube");
        tube.scene.duration = 0.05;
        tube.scene.instruments.clear();
        tube.scene.forces = {{85, {0, 0, 0.1}, 0, 1}};
        return tube;
    }

    /// With so many regions that the window shows a dialog while they are evaluated.
    static Project slow(Project project) {
        constexpr qint64 longEnough = 400; // ms
        const auto isSlow = [&] {
            QElapsedTimer timer;
            timer.start();
            evaluateModel(project);
            return timer.elapsed() > longEnough;
        };
        while (!isSlow()) {
            const std::vector<Region> regions = project.regions;
            project.regions.insert(project.regions.end(), regions.begin(), regions.end());
        }
        return project;
    }

    QToolButton* button(const QString& text) {
        for (auto* found : m_panel.findChildren<QToolButton*>())
            if (found->text() == text) return found;
        ADD_FAILURE() << "no button " << text.toStdString();
        return nullptr;
    }
    QPushButton* measure() { return m_panel.findChild<QPushButton*>(QStringLiteral("measureButton")); }
    QString inUse() { return m_panel.findChild<QLabel*>(QStringLiteral("steppingInUse"))->text(); }
    QPushButton* recommendation(const char* name) {
        return m_panel.findChild<QPushButton*>(QString::fromLatin1(name));
    }
    static void type(NumberField& field, const QString& text) {
        field.selectAll();
        QTest::keyClicks(&field, text);
        QTest::keyClick(&field, Qt::Key_Return);
    }
    const std::optional<MeasuredStepping>& stepping() { return m_document.project().stepping; }

    Document m_document;
    Preview m_preview;
    SpeedAndAccuracy m_accuracy;
    AccuracyPanel m_panel;
};

TEST_F(AccuracyPanelTest, MeasuresRecommendsAndLetsOneBeChosenAndTakenBack) {
    EXPECT_FALSE(recommendation("toError")->isVisible());
    EXPECT_FALSE(button("automatic")->isEnabled());
    measure()->click();
    ASSERT_TRUE(recommendation("toError")->isVisible());
    constexpr int columnWidth = 256; // with room for a scroll bar
    EXPECT_LE(m_panel.minimumSizeHint().width(), columnWidth);

    ASSERT_TRUE(recommendation("toError")->isEnabled());
    const QString recommended = recommendation("toError")->text();
    recommendation("toError")->click();
    ASSERT_TRUE(stepping());
    EXPECT_LE(stepping()->error, 0.01);
    EXPECT_EQ(inUse(), recommended);
    EXPECT_TRUE(button("automatic")->isEnabled());

    button("automatic")->click();
    EXPECT_FALSE(stepping());
    m_document.undoStack()->undo();
    EXPECT_TRUE(stepping());
    m_document.undoStack()->undo();
    EXPECT_FALSE(stepping());
    EXPECT_TRUE(recommendation("toError")->isVisible());

    auto* mostError = m_panel.findChild<NumberField*>(QStringLiteral("mostError"));
    type(*mostError, "0.000001");
    EXPECT_FALSE(recommendation("toError")->isEnabled());
    type(*mostError, "50");
    EXPECT_TRUE(recommendation("toError")->isEnabled());

    auto* hint = m_panel.findChild<QLabel*>(QStringLiteral("accuracyHint"));
    EXPECT_FALSE(hint->isVisible());
    m_document.edit("softer", [](Project& project) { project.regions.back().held.viscosity = 99; });
    ESM_EVENTUALLY(hint->isVisible());
    EXPECT_TRUE(recommendation("toError")->isVisible());
}

TEST_F(AccuracyPanelTest, WhatWasMeasuredIsAStepThatCanBeTakenBack) {
    measure()->click();
    ASSERT_TRUE(m_document.project().accuracy);
    EXPECT_TRUE(m_document.isModified());
    m_document.undoStack()->undo();
    EXPECT_FALSE(recommendation("toError")->isVisible());
    m_document.undoStack()->redo();
    EXPECT_TRUE(recommendation("toError")->isVisible());
}

TEST_F(AccuracyPanelTest, LeavesWhatCameWhileAStepWasChosen) {
    measure()->click();
    ASSERT_TRUE(recommendation("toError")->isEnabled());
    m_document.edit("slow", [](Project& project) { project = slow(project); });
    QTimer::singleShot(0, &m_panel,
                       [this] { m_document.edit("late", [](Project& project) { project.name = "late"; }); });
    recommendation("toError")->click();
    EXPECT_TRUE(stepping());
    ESM_EVENTUALLY(m_document.project().name == "late");
}

TEST_F(AccuracyPanelTest, SaysOfAnOpenedProjectThatItsTissueHasChanged) {
    const auto* hint = m_panel.findChild<QLabel*>(QStringLiteral("accuracyHint"));
    const auto warns = [&] { return hint->text().contains(QStringLiteral("have changed since")); };
    Project tube = briefTube();
    tube.stepping = {{Integrator::Split2, 0.01, Precision::Double}, 0.01, 0.1, ""};
    tube.stepping->tissue = tissueDigest(evaluateModel(tube));
    m_document.replace(tube, std::nullopt);
    ESM_EVENTUALLY(!m_accuracy.isComparing());
    EXPECT_FALSE(warns());
    m_document.edit("stiffer", [](Project& project) { project.regions.back().held.springConstant = 99; });
    EXPECT_TRUE(QTest::qWaitFor(warns, patience));
    m_document.undoStack()->undo();
    EXPECT_TRUE(QTest::qWaitFor([&] { return !warns(); }, patience));
}

TEST_F(AccuracyPanelTest, KeepsTheMeasurementWhenARunOnFewerNodesIsChosen) {
    Project sheet = makeProject("sheet", {tissue::gridMesh(16, 0.1), {}});
    sheet.scene.gravity = {0, 0, -1};
    sheet.scene.duration = sheet.scene.record.every = 0.002;
    m_document.replace(sheet, std::nullopt);
    const auto network = m_document.project().network;
    const std::size_t fewer = networkOf(*sheet.mesh, {Detail::Kind::Nodes, 64}).restPositions.size();
    ASSERT_LT(fewer, 256U);
    measure()->click();
    ASSERT_TRUE(recommendation("toError")->isVisible());

    const auto nodes = [this] { return m_document.project().network->restPositions.size(); };
    const auto choose = [&](std::size_t wanted) {
        const auto runs = m_accuracy.tradeoff()->runs;
        const auto run = std::find_if(runs.begin(), runs.end(), [&](const TradeoffRun& each) {
            return each.stable && each.nodes == wanted;
        });
        ASSERT_NE(run, runs.end());
        m_accuracy.use(static_cast<std::size_t>(run - runs.begin()), &m_panel);
        ASSERT_EQ(nodes(), wanted);
        EXPECT_EQ(m_accuracy.runInUse(), static_cast<std::size_t>(run - runs.begin()));
        m_preview.setProject(m_document.project());
        ESM_EVENTUALLY(m_preview.tissue() && m_preview.tissue()->mass.size() == wanted);
        ESM_EVENTUALLY(!m_accuracy.isComparing());
        EXPECT_FALSE(m_accuracy.isOutdated());
    };
    choose(fewer);
    EXPECT_TRUE(recommendation("toError")->isVisible());
    choose(256);
    EXPECT_EQ(m_document.project().network->restPositions, network->restPositions);
    EXPECT_EQ(tissueDigest(evaluateModel(m_document.project())), tissueDigest(evaluateModel(sheet)));
    EXPECT_EQ(m_document.project().scene, sheet.scene);
}

TEST_F(AccuracyPanelTest, LetsALargeOrganComputeForLonger) {
    type(*m_panel.findChild<NumberField*>(QStringLiteral("mostSeconds")), "6");
    EXPECT_EQ(m_accuracy.mostSecondsPerRun(), 6);
}

TEST_F(AccuracyPanelTest, CancelledItLeavesAllAsItWas) {
    m_preview.setProject(m_document.project());
    QTimer cancel;
    QObject::connect(&cancel, &QTimer::timeout, [] {
        for (QWidget* window : QApplication::topLevelWidgets())
            if (auto* dialog = qobject_cast<QProgressDialog*>(window))
                dialog->findChild<QPushButton*>()->click();
    });
    cancel.start(20);
    Project large = makeSample("liver");
    m_document.replace(large, std::nullopt);
    measure()->click();
    EXPECT_FALSE(recommendation("toError")->isVisible());
    EXPECT_FALSE(stepping());
    EXPECT_FALSE(m_document.isModified());
}

} // namespace
