#include "app/editor/window/shortcuts.h"

#include "app/editor/tools/tool_table.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>
#include <QUndoStack>

using namespace esm;

namespace {

class ShortcutsTest : public testing::Test {
protected:
    ShortcutKeys restored() { return restoredKeys(settings, rows, usual); }
    QList<QKeySequence> restored(const QString& id) { return restored().at(id); }
    void store(const QString& id, const QString& keys) { settings.setValue("shortcuts/" + id, keys); }

    TemporaryFolder folder;
    QSettings settings{QString::fromStdString((folder / "esm.ini").string()), QSettings::IniFormat};
    QWidget window;
    QUndoStack steps;
    Actions actions = createActions(&window, &steps);
    const std::vector<ShortcutRow> rows = shortcutRows(actions);
    const ShortcutKeys usual = keysOf(rows);
};

} // namespace

TEST_F(ShortcutsTest, EveryActionWithAKeyCanHaveAnother) {
    EXPECT_EQ(usual.size(), rows.size()) << "each has an id of its own";
    for (const QAction* action : window.actions())
        EXPECT_TRUE(std::any_of(rows.begin(), rows.end(), [&](const auto& row) {
            return row.action == action;
        })) << action->text().toStdString();
    for (const ToolRow& tool : toolTable())
        EXPECT_EQ(usual.at("tool/" + tool.name), QList<QKeySequence>{tool.key});
}

TEST_F(ShortcutsTest, KeysComeBackAsTheyWereChosen) {
    ShortcutKeys own = usual;
    own["addRegion"] = {QKeySequence("Ctrl+T")};
    own["tool/pull"] = {};
    own["redo"] = {QKeySequence("Ctrl+Y"), QKeySequence("F7")};
    saveKeys(settings, own, usual);
    EXPECT_EQ(restored(), own);
    saveKeys(settings, usual, usual);
    EXPECT_EQ(restored(), usual);
    EXPECT_TRUE(settings.allKeys().isEmpty()) << "what is as usual is not written down";
}

TEST_F(ShortcutsTest, ToolTipsAndHintsFollow) {
    ShortcutKeys own = usual;
    own["addRegion"] = {QKeySequence("Ctrl+T")};
    own["play"] = {};
    giveKeys(rows, own);
    EXPECT_TRUE(actions.addRegion->toolTip().endsWith("(Ctrl+T)"));
    EXPECT_FALSE(actions.play->toolTip().contains('('));
    EXPECT_EQ(withKeys("{addRegion} adds one, {play} moves it", actions),
              "Ctrl+T adds one, “Play or pause” moves it");
    enable(actions.addRegion, false, "Add", "There is no organ");
    giveKeys(rows, usual);
    EXPECT_EQ(actions.addRegion->toolTip(), "There is no organ") << "why not stays said";
    enable(actions.addRegion, true, "Add", "");
    EXPECT_EQ(actions.addRegion->toolTip(), "Add (Ctrl+R)");
}

TEST_F(ShortcutsTest, WhatIsNotSeenIsExplainedAndComesBackAsItWas) {
    actions.play->setVisible(false);
    explain(actions.play, "Move");
    actions.play->setVisible(true);
    EXPECT_TRUE(actions.play->isEnabled());
    EXPECT_EQ(actions.play->toolTip(), "Move (Space)");
}

TEST_F(ShortcutsTest, BadSettingsAreIgnored) {
    store("noSuchAction", "Ctrl+J");
    store("save", "no key at all");
    store("open", "Ctrl+K, Ctrl+L");
    store("quit", "Up");
    EXPECT_EQ(restored(), usual);
}

TEST_F(ShortcutsTest, AKeyIsNeverOfTwoActions) {
    store("addRegion", "Ctrl+S");
    EXPECT_EQ(restored(), usual) << "another action has it as usual";
    store("addRegion", "F7");
    store("addPhoto", "F7");
    const ShortcutKeys keys = restored();
    for (const ShortcutRow& row : rows)
        for (const QKeySequence& key : keys.at(row.id))
            EXPECT_EQ(holderOf(rows, keys, key, row.id), nullptr) << row.id.toStdString();
    EXPECT_EQ(keys.at("addRegion").contains(QKeySequence("F7")) +
                  keys.at("addPhoto").contains(QKeySequence("F7")),
              1);
    store("addRegion", "Ctrl+P");
    store("addPhoto", "Ctrl+R");
    EXPECT_EQ(restored("addRegion"), QList<QKeySequence>{QKeySequence("Ctrl+P")}) << "two may change places";
    EXPECT_EQ(restored("addPhoto"), QList<QKeySequence>{QKeySequence("Ctrl+R")});
}
