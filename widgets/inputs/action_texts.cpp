#include "widgets/inputs/action_texts.h"

#include <QVariant>

namespace esm {

namespace {

constexpr auto doesProperty = "does";

} // namespace

QString withShortcut(const QString& toolTip, const QAction* action) {
    const QString key = action->shortcut().toString(QKeySequence::NativeText);
    return key.isEmpty() ? toolTip : QStringLiteral("%1 (%2)").arg(toolTip, key);
}

QString plainText(const QAction* action) {
    return action->text().remove('&').remove(QChar(0x2026));
}

void explain(QAction* action, const QString& does) {
    enable(action, action->isEnabled(), does, action->toolTip());
}

QString whatItDoes(const QAction* action) {
    return action->property(doesProperty).toString();
}

void enable(QAction* action, bool on, const QString& does, const QString& why) {
    action->setEnabled(on);
    action->setProperty(doesProperty, does);
    action->setToolTip(on ? withShortcut(does, action) : why);
}

void setKeys(QAction* action, const QList<QKeySequence>& keys) {
    action->setShortcuts(keys);
    explain(action, whatItDoes(action));
}

} // namespace esm
