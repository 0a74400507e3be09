#pragma once

#include "app/editor/window/shortcuts.h"
#include "widgets/inputs/key_field.h"

#include <QDialog>
#include <QLabel>
#include <QPushButton>
#include <QTreeWidget>

namespace esm {

/// The keys of all actions, to be changed by typing others. A key that another action has is told at once,
/// and moved where that is wanted. Nothing is another before the dialog was accepted.
class ShortcutsDialog : public QDialog {
    Q_OBJECT

public:
    ShortcutsDialog(std::vector<ShortcutRow> rows, const ShortcutKeys& usual, QWidget* parent = nullptr);

    const ShortcutKeys& chosen() const { return m_keys; }

private:
    void fillList();
    void makeButtons();
    QWidget* makeEditor();
    QPushButton* addButton(QLayout* row, const char* name, const QString& text,
                           void (ShortcutsDialog::*does)());
    const ShortcutRow* row() const;
    void chooseRow();
    void take(const QKeySequence& key);
    void moveHere();
    void clearKey();
    void reset();
    void resetAll();
    void setKeysOfRow(const QList<QKeySequence>& keys);
    void showKeys();
    void say(const QString& message, const QKeySequence& wanted = {});

    const std::vector<ShortcutRow> m_rows;
    const ShortcutKeys m_usual;
    ShortcutKeys m_keys;
    QKeySequence m_wanted; ///< that another action has
    QTreeWidget* m_list;
    KeyField* m_field;
    QLabel* m_message;
    QPushButton *m_move, *m_clear, *m_reset;
};

} // namespace esm
