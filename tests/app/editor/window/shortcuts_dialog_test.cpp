#include "app/editor/window/shortcuts_dialog.h"

#include "core/samples/samples.h"
#include "tests/app/access_complaints.h"
#include "tests/app/editor_driver.h"

using namespace esm;

namespace {

class ShortcutsDialogTest : public EditorTest {
protected:
    void SetUp() override { open(makeSample("liver")); }
    void TearDown() override { QSettings().remove("shortcuts"); }

    void change(const std::function<void()>& does, bool accepts = true) {
        dialogs.expectNamed("shortcutsDialog", [=, this](QDialog* dialog) {
            m_dialog = dialog;
            does();
            accepts ? dialog->accept() : dialog->reject();
        });
        window->windowActions().shortcuts->trigger();
        ASSERT_TRUE(dialogs.isDone());
    }
    template<typename Widget> Widget* part(const char* name) const {
        return m_dialog->findChild<Widget*>(name);
    }
    void choose(const QString& name) const {
        const auto found =
            part<QTreeWidget>("shortcutList")->findItems(name, Qt::MatchExactly | Qt::MatchRecursive);
        ASSERT_FALSE(found.isEmpty()) << name.toStdString();
        part<QTreeWidget>("shortcutList")->setCurrentItem(found.front());
    }
    void type(Qt::Key key, Qt::KeyboardModifiers modifiers = {}) const {
        QTest::keyClick(part<KeyField>("shortcutField"), key, modifiers);
    }
    void push(const char* name) const { QTest::mouseClick(part<QPushButton>(name), Qt::LeftButton); }
    QString said() const { return part<QLabel>("shortcutMessage")->text(); }
    bool hasRegion() const { return !project().regions.empty() && project().regions.back().ellipsoid; }

    QDialog* m_dialog = nullptr;
};

} // namespace

TEST_F(ShortcutsDialogTest, ATypedKeyWorksAtOnceAndInTheNextWindow) {
    change([&] {
        choose("Add region");
        type(Qt::Key_T, Qt::ControlModifier);
        EXPECT_EQ(said(), "");
    });
    const std::size_t before = project().regions.size();
    press(Qt::Key_R, Qt::ControlModifier);
    EXPECT_EQ(project().regions.size(), before);
    press(Qt::Key_T, Qt::ControlModifier);
    EXPECT_EQ(project().regions.size(), before + 1);
    open(makeSample("liver"));
    window->restore();
    EXPECT_EQ(window->windowActions().addRegion->shortcut(), QKeySequence("Ctrl+T"));
    EXPECT_TRUE(window->windowActions().addRegion->toolTip().contains("Ctrl+T"));
}

TEST_F(ShortcutsDialogTest, ATakenKeyIsToldAndMovedWhereWanted) {
    change([&] {
        choose("Instrument");
        type(Qt::Key_P);
        EXPECT_TRUE(said().contains("P is the key of “Pull” in the menu Tools")) << said().toStdString();
        push("moveShortcut");
        EXPECT_TRUE(said().contains("“Pull” has no key now")) << said().toStdString();
        type(Qt::Key_Up);
        EXPECT_TRUE(said().contains("cannot be a shortcut")) << said().toStdString();
    });
    press(Qt::Key_P);
    EXPECT_EQ(toolInHand(), "instrument");
    change([&] { push("resetShortcuts"); });
    press(Qt::Key_P);
    EXPECT_EQ(toolInHand(), "pull");
}

TEST_F(ShortcutsDialogTest, NothingChangesWhereItIsLeft) {
    change(
        [&] {
            choose("Add region");
            push("clearShortcut");
            EXPECT_TRUE(accessComplaints(*m_dialog).isEmpty())
                << accessComplaints(*m_dialog).join('\n').toStdString();
            push("resetShortcut");
            type(Qt::Key_T, Qt::ControlModifier);
        },
        false);
    EXPECT_EQ(window->windowActions().addRegion->shortcut(), QKeySequence("Ctrl+R"));
}
