#include "app/editor/window/theme.h"
#include "core/authoring/accuracy.h"
#include "core/exchange/image_file.h"
#include "core/samples/samples.h"
#include "tests/app/editor_driver.h"
#include "tests/support/temporary_folder.h"
#include "widgets/inputs/elided_label.h"

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDockWidget>
#include <QLabel>
#include <QLayout>
#include <QTableView>
#include <QToolBar>
#include <QToolButton>

#include <algorithm>
#include <fstream>

using namespace esm;

namespace {

/// What a screen of 1600 × 1000 pixels with a display scale of 2 leaves within a window's frame.
const QSize smallRoom(796, 456);

/// The editor on such a screen.
class NarrowTest : public EditorTest {
protected:
    void SetUp() override {
        applyTheme(*qApp, Theme::Dark);
        open(makeSample("tube"));
        window->resize(smallRoom);
        ESM_EVENTUALLY(window->size() == smallRoom);
        settle();
    }
    void settle() const { settledHeight(window.get()); }
    void take(const char* tool) {
        window->windowActions().tool(tool)->trigger();
        settle();
    }
    void addPhoto() {
        writePng(makeSamplePhoto(samplePhotoNames().front())->image, folder / "photo.png");
        window->openFiles({folder / "photo.png"});
        settle();
    }
    /// As if it was measured, with long names of methods.
    void measure() {
        Tradeoff measured;
        measured.reference.stepping = {Integrator::Rk4, 1e-5, Precision::Double};
        measured.runs = {{{Integrator::Split2, 0.01, Precision::Double}, 170, true, 0.02, false, 0.1, {}},
                         {{Integrator::Split, 0.02, Precision::Double}, 170, true, 0.2, true, 2.1e-6, {}}};
        window->document().edit("measure", [&](Project& edited) {
            edited.accuracy = std::make_shared<const MeasuredAccuracy>(
                measuredAccuracy(measuredOrgan(edited), detailOf(*edited.network), measured));
        });
        window->windowActions().measure->trigger();
        settle();
    }
    /// Labels and buttons that are too narrow for what they say.
    QStringList cutTexts() const {
        QStringList cut;
        for (auto* label : window->findChildren<QLabel*>()) {
            const bool isOneLine = !label->wordWrap() && !qobject_cast<ElidedLabel*>(label);
            if (label->isVisible() && isOneLine && label->width() < label->sizeHint().width())
                cut << label->text();
        }
        for (auto* button : window->findChildren<QAbstractButton*>())
            if (button->isVisible() && !button->text().isEmpty() &&
                button->width() < button->minimumSizeHint().width())
                cut << button->text();
        return cut;
    }
    /// Every widget in a row stands within it, and none on another.
    static void expectApart(const QList<QWidget*>& widgets, const QRect& within) {
        QRegion taken;
        for (const QWidget* widget : widgets) {
            if (!widget->isVisible()) continue;
            EXPECT_TRUE(within.contains(widget->geometry())) << widget->objectName().toStdString();
            EXPECT_FALSE(taken.intersects(widget->geometry())) << widget->objectName().toStdString();
            taken += widget->geometry();
        }
    }
    static void expectRoomFor(QWidget& shown) {
        const QSize least = shown.minimumSizeHint().expandedTo(shown.minimumSize());
        EXPECT_TRUE(least.boundedTo(smallRoom) == least)
            << shown.objectName().toStdString() << " " << least.width() << " x " << least.height();
    }
    void lookAtNextDialog(const char* name) {
        dialogs.expectNamed(name, [](QDialog* dialog) {
            expectRoomFor(*dialog);
            dialog->reject();
        });
    }
    void expectRoomForWindow(const char* name) {
        auto* shown = child<QWidget>(name);
        ASSERT_NE(shown, nullptr) << name;
        expectRoomFor(*shown);
    }

    TemporaryFolder folder;
};

} // namespace

TEST_F(NarrowTest, EveryToolIsInSight) {
    const auto* strip = child<QToolBar>("toolStrip");
    QList<QWidget*> buttons;
    for (QAction* tool : window->windowActions().tools->actions())
        buttons << strip->widgetForAction(tool);
    ASSERT_GE(buttons.size(), 10);
    for (const QWidget* button : buttons)
        EXPECT_TRUE(button->isVisible());
    expectApart(buttons, strip->rect());
    EXPECT_FALSE(child<QWidget>("qt_toolbar_ext_button")->isVisible());
    window->resize(1200, 800);
    ESM_EVENTUALLY(buttons.front()->height() == 34);
}

TEST_F(NarrowTest, TheOptionsOfTheInstrumentStandApartAndWhole) {
    take("instrument");
    auto* kind = child<QComboBox>("instrumentKind");
    for (const int chosen : {0, 1}) {
        kind->setCurrentIndex(chosen);
        emit kind->activated(chosen);
        settle();
        QWidget* options = kind->parentWidget();
        expectApart(options->findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly), options->rect());
        const QRect inWindow(options->mapTo(window.get(), QPoint()), options->size());
        EXPECT_TRUE(window->rect().contains(inWindow));
        EXPECT_EQ(cutTexts(), QStringList());
    }
    take("look");
    EXPECT_FALSE(kind->isVisible());
}

TEST_F(NarrowTest, NoTextIsCutInAnyWorkspace) {
    measure();
    for (QAction* workspace :
         {window->windowActions().tissue, window->windowActions().texture, window->windowActions().measure}) {
        workspace->trigger();
        settle();
        EXPECT_EQ(cutTexts(), QStringList()) << workspace->text().toStdString();
    }
    auto* pages = child<QTabBar>("measurePages");
    for (int page = 0; page < pages->count(); ++page) {
        pages->setCurrentIndex(page);
        settle();
        EXPECT_EQ(cutTexts(), QStringList()) << pages->tabText(page).toStdString();
        EXPECT_EQ(window->size(), smallRoom) << pages->tabText(page).toStdString();
    }
}

TEST_F(NarrowTest, ChartAndTableOfMeasurementsTakeTurns) {
    measure();
    auto* tabs = child<QTabBar>("measureTabs");
    auto *chart = child<QWidget>("accuracyChart"), *table = child<QWidget>("runsTable");
    ASSERT_TRUE(tabs->isVisible());
    EXPECT_TRUE(chart->isVisible());
    EXPECT_GE(chart->height(), chart->minimumSizeHint().height());
    EXPECT_EQ(chart->visibleRegion().boundingRect(), chart->rect());
    EXPECT_FALSE(table->isVisible());
    tabs->setCurrentIndex(1);
    settle();
    EXPECT_FALSE(chart->isVisible());
    EXPECT_TRUE(table->isVisible());
    const auto& view = *child<QTableView>("runsTable");
    int columns = 0;
    for (int column = 0; column < view.model()->columnCount(); ++column) {
        const QString text = view.model()->index(0, column).data().toString();
        EXPECT_GT(view.columnWidth(column), view.fontMetrics().horizontalAdvance(text)) << column;
        columns += view.columnWidth(column);
    }
    EXPECT_LE(columns, view.viewport()->width());
    window->resize(1280, 760);
    ESM_EVENTUALLY(chart->isVisible() && table->isVisible());
    EXPECT_FALSE(tabs->isVisible());
    const QString longest = view.model()->index(1, 0).data().toString();
    EXPECT_EQ(longest, "viscous split, second order");
    ESM_EVENTUALLY(view.columnWidth(0) > view.fontMetrics().horizontalAdvance(longest));
}

TEST_F(NarrowTest, WindowsBesideTheOrganHaveRoom) {
    addPhoto();
    window->windowActions().history->trigger();
    expectRoomForWindow("historyWindow");
    window->windowActions().fuzzyWindow->trigger();
    auto* tabs = child<QTabBar>("workbenchTabs");
    for (int tab = 0; tab < tabs->count(); ++tab) {
        tabs->setCurrentIndex(tab);
        settle();
        expectRoomForWindow("workbenchWindow");
        EXPECT_LE(child<QWidget>("workbenchWindow")->layout()->minimumSize().height(), smallRoom.height());
    }
    window->windowActions().fuzzyWindow->trigger();
    window->windowActions().texture->trigger();
    child<QAbstractButton>("largePhoto")->click();
    for (auto* tool : child<QDialog>("photoDialog")->findChildren<QAbstractButton*>()) {
        if (!tool->isCheckable() || !tool->isVisible()) continue;
        tool->click();
        expectRoomForWindow("photoDialog");
    }
}

TEST_F(NarrowTest, NoticesAreWideAndLeaveTheChoicesOfTheView) {
    window->windowActions().firstSteps->trigger();
    window->windowActions().cut->trigger();
    for (const QSize& size : {smallRoom, QSize(1440, 860)}) {
        window->resize(size);
        ESM_EVENTUALLY(window->size() == size);
        settle();
        const auto notices = window->view().findChildren<QWidget*>("viewNotice");
        const auto shown = std::find_if(notices.begin(), notices.end(),
                                        [](const QWidget* notice) { return notice->isVisible(); });
        ASSERT_NE(shown, notices.end());
        EXPECT_GE((*shown)->width(), 320);
        EXPECT_LE((*shown)->height(), 100);
        const auto* choices = child<QWidget>(size == smallRoom ? "showButton" : "viewBar");
        const QRect inView(choices->mapTo(&window->view(), QPoint()), choices->size());
        EXPECT_FALSE((*shown)->geometry().intersects(inView));
        for (const auto* button : (*shown)->findChildren<QAbstractButton*>())
            EXPECT_GE(button->width(), button->minimumSizeHint().width()) << button->text().toStdString();
    }
}

TEST_F(NarrowTest, TheOptionsOfAToolComeInSight) {
    child<QDockWidget>("Fuzzy system")->raise();
    settle();
    take("distance");
    auto* length = child<QWidget>("trueLength");
    ESM_EVENTUALLY(length->visibleRegion().boundingRect() == length->rect());
}

TEST_F(NarrowTest, ToolsKeepTheirKeysWhereThePanelsMakeRoom) {
    addPhoto();
    child<QWidget>("photoList")->setFocus();
    take("landmarks");
    ESM_EVENTUALLY(window->view().hasFocus());
}

TEST_F(NarrowTest, QuestionsHaveRoom) {
    lookAtNextDialog("shortcutsDialog");
    window->windowActions().shortcuts->trigger();
    lookAtNextDialog("keysDialog");
    window->windowActions().keys->trigger();
    std::ofstream(folder / "box.obj") << "v 0 0 0\nv 90 0 0\nv 0 90 0\nv 0 0 90\nf 1 3 2\nf 1 2 4\nf 1 4 3\n";
    lookAtNextDialog("importDialog");
    window->openFiles({folder / "box.obj"});
    EXPECT_TRUE(dialogs.isDone());
}
