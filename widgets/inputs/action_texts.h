#pragma once

#include <QAction>

namespace esm {

/// "Bring the whole organ into view (Home)": a tool tip with the action's key, where it has one.
QString withShortcut(const QString& toolTip, const QAction* action);
/// A text as people read it, without the mark of the letter that its key is.
QString withoutMnemonic(const QString& text);
/// An action's text as people read it, without the mark of its letter and the dots of what asks first.
QString plainText(const QAction* action);
/// By what it is named in a sentence: its key, or where it has none its text in quotation marks.
QString keyOrName(const QAction* action);

/// Says what an action does: in its tool tip with its key, unless that says why it cannot be used.
void explain(QAction* action, const QString& does);
/// As it was explained last, without the key.
QString whatItDoes(const QAction* action);
/// Enables an action; its tool tip says what it does and its key, or why it cannot be used now.
void enable(QAction* action, bool on, const QString& does, const QString& why);
/// Gives an action other keys, which its tool tip follows.
void setKeys(QAction* action, const QList<QKeySequence>& keys);

} // namespace esm
