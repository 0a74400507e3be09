#include "app/editor/panels/fuzzy/domains_panel.h"
#include "app/editor/panels/fuzzy/rules_panel.h"
#include "app/editor/panels/fuzzy/spare_systems_button.h"
#include "core/authoring/regions.h"
#include "core/samples/samples.h"
#include "tests/app/editor_driver.h"

#include <QMenu>
#include <QMouseEvent>

using namespace esm;

namespace {

/// The organ and a region in hand, which have one fuzzy system.
class SharedSystemTest : public EditorTest {
protected:
    void SetUp() override {
        open(makeSample("tube"));
        addPublishedRegion();
        before = project();
        ASSERT_EQ(system(0), system(1));
    }
    void answer(const QString& button) {
        dialogs.expectNamed("reachBox", [this, button](QDialog* box) {
            ++asked;
            EXPECT_EQ(project(), before) << "nothing changes before the answer";
            EXPECT_TRUE(qobject_cast<QMessageBox*>(box)->informativeText().contains(
                QStringLiteral("“Tube”, “Region 1”")));
            if (button.isEmpty()) return box->reject();
            box->findChild<QPushButton*>(button)->click();
        });
    }
    void dragCorner(int by) {
        chooseTab("Domains");
        QTest::qWait(0);
        auto* partition = child<PartitionEditor>("partition");
        const QPoint from = partition->placeOf(0, Corner::D);
        QTest::mousePress(partition, Qt::LeftButton, {}, from);
        for (const int step : {by / 2, by}) {
            QMouseEvent event(QEvent::MouseMove, from + QPoint(step, 0), Qt::NoButton, Qt::LeftButton, {});
            QApplication::sendEvent(partition, &event);
        }
        QTest::mouseRelease(partition, Qt::LeftButton, {}, from + QPoint(by, 0));
    }
    void typeInRules(const QString& text) {
        chooseTab("Rules");
        edit()->setFocus();
        QTest::keyClick(edit(), Qt::Key_End, Qt::ControlModifier);
        QTest::keyClicks(edit(), text);
    }
    RuleTextEdit* edit() const { return window->findChild<RulesPanel*>()->text(); }
    const FuzzySystem& system(std::size_t region) const { return *project().regions.at(region).system; }
    double end(std::size_t region) const { return system(region).inputs[0].terms[0].set.d; }
    QString users() const { return child<QLabel>("systemUsers")->text(); }
    int steps() const { return window->document().undoStack()->index(); }

    Project before = makeSample("tube");
    int asked = 0;
};

} // namespace

TEST_F(SharedSystemTest, IsSaidToBeSharedWithTheNamesOfItsUsers) {
    EXPECT_EQ(users(), "used by 2 regions");
    EXPECT_TRUE(child<QLabel>("systemUsers")->toolTip().contains("Tube, Region 1"));
    window->document().edit("Other", [](Project& p) { setSystem(p, p.regions[0].id, nullptr); });
    EXPECT_EQ(users(), "used by this region alone");
}

TEST_F(SharedSystemTest, AsksAfterADragAndChangesItForAll) {
    const int step = steps();
    answer("everyRegion");
    dragCorner(20);
    EXPECT_TRUE(dialogs.isDone());
    EXPECT_GT(end(1), before.regions[1].system->inputs[0].terms[0].set.d);
    EXPECT_EQ(system(0), system(1));
    EXPECT_EQ(users(), "used by 2 regions · changes are for all of them");
    dragCorner(20);
    EXPECT_EQ(asked, 1);
    EXPECT_EQ(steps(), step + 2);
}

TEST_F(SharedSystemTest, MakesACopyOfADragInOneStep) {
    const int step = steps();
    answer("copyForOne");
    dragCorner(20);
    EXPECT_EQ(system(0), *before.regions[0].system);
    EXPECT_EQ(system(1).name, "susilap-g, own");
    EXPECT_GT(end(1), end(0));
    EXPECT_EQ(project().regions[1].inputs, before.regions[1].inputs);
    EXPECT_EQ(users(), "used by this region alone");
    EXPECT_EQ(steps(), step + 1);
    dragCorner(10);
    EXPECT_EQ(asked, 1);
    window->document().undoStack()->undo();
    window->document().undoStack()->undo();
    EXPECT_EQ(project(), before);
}

TEST_F(SharedSystemTest, PutsADragBackThatIsForNobody) {
    answer({});
    dragCorner(20);
    EXPECT_EQ(project(), before);
    EXPECT_EQ(child<PartitionEditor>("partition")->variable(), system(1).inputs[0]);
}

TEST_F(SharedSystemTest, AsksAtTheFirstLetterOfRules) {
    const QString rules = edit()->toPlainText();
    answer({});
    typeInRules("x");
    EXPECT_EQ(edit()->toPlainText(), rules) << "what is for nobody goes again";
    EXPECT_TRUE(window->document().unfinished().isEmpty());
    answer("copyForOne");
    typeInRules(" WITH 0.5");
    EXPECT_TRUE(dialogs.isDone());
    EXPECT_EQ(asked, 2);
    EXPECT_EQ(system(1).rules.back().weight, 0.5);
    EXPECT_EQ(system(0), *before.regions[0].system);
}

TEST_F(SharedSystemTest, AsksAgainInAnotherRegion) {
    answer("everyRegion");
    dragCorner(20);
    window->findChild<Selection*>()->setRegion(project().regions[0].id);
    before = project();
    answer("everyRegion");
    dragCorner(20);
    EXPECT_EQ(asked, 2);
}

TEST_F(SharedSystemTest, CanBeRemovedOnlyWhenNobodyUsesIt) {
    answer("copyForOne");
    dragCorner(20);
    auto* menu = child<QMenu>("spareSystemsMenu");
    emit menu->aboutToShow();
    ASSERT_EQ(menu->actions().size(), 1) << "what ships is not there";
    EXPECT_FALSE(menu->actions()[0]->isEnabled());
    EXPECT_EQ(menu->actions()[0]->toolTip(), "Used by Region 1");
    window->document().edit("Other", [](Project& p) { setSystem(p, p.regions[1].id, nullptr); });
    ASSERT_EQ(project().spareSystems.size(), 1U);
    EXPECT_GE(child<QComboBox>("systemChoice")->findText("susilap-g, own", Qt::MatchStartsWith), 0);
    emit menu->aboutToShow();
    menu->actions()[0]->trigger();
    EXPECT_TRUE(project().spareSystems.empty());
    EXPECT_LT(child<QComboBox>("systemChoice")->findText("susilap-g, own", Qt::MatchStartsWith), 0);
    window->document().undoStack()->undo();
    EXPECT_EQ(project().spareSystems.size(), 1U);
}
