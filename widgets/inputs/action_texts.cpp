#include "widgets/inputs/action_texts.h"

#include <QVariant>

namespace esm {

namespace {

constexpr auto doesProperty = "does";
/// Why it cannot be used now. Whether it is enabled does not tell: an action that is not to be seen is not
/// enabled either.
constexpr auto whyProperty = "why";

} // namespace

QString withShortcut(const QString& toolTip, const QAction* action) {
    const QString key = action->shortcut().toString(QKeySequence::NativeText);
    return key.isEmpty() ? toolTip : QStringLiteral("%1 (%2)").arg(toolTip, key);
}

QString withoutMnemonic(const QString& text) {
    return QString(text).remove('&');
}

QString plainText(const QAction* action) {
    return withoutMnemonic(action->text()).remove(QChar(0x2026));
}

QString keyOrName(const QAction* action) {
    const QString key = action->shortcut().toString(QKeySequence::NativeText);
    return key.isEmpty() ? QStringLiteral("“%1”").arg(plainText(action)) : key;
}

void explain(QAction* action, const QString& does) {
    action->setProperty(doesProperty, does);
    const QString why = action->property(whyProperty).toString();
    action->setToolTip(why.isEmpty() ? withShortcut(does, action) : why);
}

QString whatItDoes(const QAction* action) {
    return action->property(doesProperty).toString();
}

void enable(QAction* action, bool on, const QString& does, const QString& why) {
    action->setEnabled(on);
    action->setProperty(whyProperty, on ? QString() : why);
    explain(action, does);
}

void setKeys(QAction* action, const QList<QKeySequence>& keys) {
    action->setShortcuts(keys);
    explain(action, whatItDoes(action));
}

} // namespace esm
