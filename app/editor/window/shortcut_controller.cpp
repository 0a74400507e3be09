#include "app/editor/window/shortcut_controller.h"

#include "app/editor/dialogs/ask.h"
#include "app/editor/window/shortcuts_dialog.h"

#include <QKeyEvent>

namespace esm {

ShortcutController::ShortcutController(QWidget& window, const Actions& actions)
    : QObject(&window), m_window(window), m_rows(shortcutRows(actions)), m_usual(keysOf(m_rows)) {
    connect(actions.shortcuts, &QAction::triggered, this, &ShortcutController::askForKeys);
    window.installEventFilter(this);
}

// A key that comes as far as the window itself had no use anywhere.
bool ShortcutController::eventFilter(QObject*, QEvent* event) {
    if (event->type() != QEvent::KeyPress) return false;
    const auto& press = static_cast<const QKeyEvent&>(*event);
    const QString why = whyNothingHappens(m_rows, press.key() | static_cast<int>(press.modifiers()));
    if (!why.isEmpty()) emit message(why);
    return false;
}

void ShortcutController::restore(const QSettings& settings) {
    giveKeys(m_rows, restoredKeys(settings, m_rows, m_usual));
}

void ShortcutController::askForKeys() {
    ShortcutsDialog dialog(m_rows, m_usual, &m_window);
    if (ask(m_window, [&] { return dialog.exec(); }) != QDialog::Accepted) return;
    giveKeys(m_rows, dialog.chosen());
    QSettings settings;
    saveKeys(settings, dialog.chosen(), m_usual);
}

} // namespace esm
