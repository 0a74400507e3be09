#pragma once

#include "app/editor/window/actions.h"

#include <QList>
#include <QSettings>

#include <map>
#include <vector>

namespace esm {

/// An action whose key can be changed.
struct ShortcutRow {
    QString id;    ///< in the settings
    QString group; ///< the menu that it stands in
    QString name;  ///< whatever its text says of the moment
    QAction* action;
};

/// All there are, in the order of the menus.
std::vector<ShortcutRow> shortcutRows(const Actions& actions);

/// The keys of each action, by its id; the first is the one that tool tips say.
using ShortcutKeys = std::map<QString, QList<QKeySequence>>;

/// "Ctrl+Shift+Z, Ctrl+Y", as people read keys.
QString shownKeys(const QList<QKeySequence>& keys);

ShortcutKeys keysOf(const std::vector<ShortcutRow>& rows);
/// Tool tips, menus and buttons follow.
void giveKeys(const std::vector<ShortcutRow>& rows, const ShortcutKeys& keys);

/// Those that are not as usual.
void saveKeys(QSettings& settings, const ShortcutKeys& keys, const ShortcutKeys& usual);
/// The usual ones, changed as the settings say. What no action is called, what is no single key, what is
/// kept for something else and what two actions claim is ignored.
ShortcutKeys restoredKeys(const QSettings& settings, const std::vector<ShortcutRow>& rows,
                          const ShortcutKeys& usual);

/// Which other action has a key; null for none.
const ShortcutRow* holderOf(const std::vector<ShortcutRow>& rows, const ShortcutKeys& keys,
                            const QKeySequence& key, const QString& except);
/// Why a key does nothing now: what the action that has it says, which cannot be used. Empty where none has
/// it.
QString whyNothingHappens(const std::vector<ShortcutRow>& rows, const QKeySequence& key);
/// What a key does that no action can have; empty for others.
QString keptFor(const QKeySequence& key);

/// The text with each action's key in place of its id: "{addRegion} adds one" is "Ctrl+R adds one". Where an
/// action has no key its name in the menu stands there.
QString withKeys(QString text, const Actions& actions);

} // namespace esm
