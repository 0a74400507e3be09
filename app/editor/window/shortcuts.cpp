#include "app/editor/window/shortcuts.h"

#include "app/editor/tools/tool_table.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>

namespace esm {

namespace {

const QString shortcutsKey = QStringLiteral("shortcuts");

struct ShortcutTexts {
    Q_DECLARE_TR_FUNCTIONS(ShortcutTexts)
};

using NamedActions = std::initializer_list<std::pair<const char*, QAction*>>;

class RowMaker {
public:
    void add(const QString& group, NamedActions actions) {
        for (const auto& [id, action] : actions)
            m_rows.push_back({QLatin1String(id), group, plainText(action), action});
    }
    void addNamed(const QString& group, const QString& prefix, const QList<QAction*>& actions,
                  const QString& name = QStringLiteral("%1")) {
        for (QAction* action : actions)
            m_rows.push_back({prefix + action->objectName(), group, name.arg(plainText(action)), action});
    }
    void addOne(const QString& group, const char* id, const QString& name, QAction* action) {
        m_rows.push_back({QLatin1String(id), group, name, action});
    }
    const std::vector<ShortcutRow>& rows() const { return m_rows; }

private:
    std::vector<ShortcutRow> m_rows;
};

void addView(RowMaker& rows, const Actions& a) {
    const QString view = ShortcutTexts::tr("View");
    rows.add(view, {{"tissue", a.tissue},
                    {"texture", a.texture},
                    {"measure", a.measure},
                    {"showSurface", a.showSurface},
                    {"showWireframe", a.showWireframe},
                    {"showSprings", a.showSprings},
                    {"showNodes", a.showNodes},
                    {"showRegions", a.showRegions},
                    {"showProjector", a.showProjector},
                    {"showBare", a.showBare}});
    rows.addNamed(view, QStringLiteral("colourBy/"), a.colourings->actions(),
                  ShortcutTexts::tr("Colour by: %1"));
    rows.add(view, {{"cut", a.cut}, {"frame", a.frame}, {"frameSelection", a.frameSelection}});
    const std::array<std::pair<const char*, QString>, 6> sides{
        {{"lookFrom/front", ShortcutTexts::tr("Look from the front")},
         {"lookFrom/back", ShortcutTexts::tr("Look from the back")},
         {"lookFrom/left", ShortcutTexts::tr("Look from the left")},
         {"lookFrom/right", ShortcutTexts::tr("Look from the right")},
         {"lookFrom/top", ShortcutTexts::tr("Look from the top")},
         {"lookFrom/bottom", ShortcutTexts::tr("Look from the bottom")}}};
    for (std::size_t i = 0; i < sides.size(); ++i)
        rows.addOne(view, sides[i].first, sides[i].second, a.standardViews[i]);
    rows.add(view, {{"lookFromWithin", a.lookFromWithin},
                    {"lookThroughPhoto", a.lookThroughPhoto},
                    {"orthographic", a.orthographic},
                    {"endoscopeLight", a.endoscopeLight},
                    {"showLeft", a.showLeft},
                    {"showRight", a.showRight},
                    {"fuzzyWindow", a.fuzzyWindow},
                    {"referenceWindow", a.referenceWindow},
                    {"lightTheme", a.lightTheme}});
}

bool isSingleKey(const QKeySequence& key) {
    return key.count() == 1 && (key[0] & ~int(Qt::KeyboardModifierMask)) != Qt::Key_unknown;
}

/// None where something stored is no key that an action can have.
std::optional<QList<QKeySequence>> readKeys(const QString& stored) {
    QList<QKeySequence> keys;
    for (const QString& text : stored.split(QStringLiteral("; "), Qt::SkipEmptyParts)) {
        const QKeySequence key = QKeySequence::fromString(text, QKeySequence::PortableText);
        if (!isSingleKey(key) || !keptFor(key).isEmpty()) return std::nullopt;
        keys << key;
    }
    return keys;
}

QString writtenKeys(const QList<QKeySequence>& keys) {
    return QKeySequence::listToString(keys, QKeySequence::PortableText);
}

} // namespace

std::vector<ShortcutRow> shortcutRows(const Actions& a) {
    RowMaker rows;
    rows.add(ShortcutTexts::tr("File"), {{"open", a.open},
                                         {"import", a.import},
                                         {"save", a.save},
                                         {"saveAs", a.saveAs},
                                         {"export", a.exportPackage},
                                         {"close", a.close},
                                         {"quit", a.quit}});
    rows.addOne(ShortcutTexts::tr("Edit"), "undo", ShortcutTexts::tr("Undo"), a.undo);
    rows.addOne(ShortcutTexts::tr("Edit"), "redo", ShortcutTexts::tr("Redo"), a.redo);
    rows.add(ShortcutTexts::tr("Edit"), {{"history", a.history},
                                         {"duplicateRegion", a.duplicateRegion},
                                         {"removeRegion", a.removeRegion},
                                         {"hidePhoto", a.hidePhoto},
                                         {"duplicatePhoto", a.duplicatePhoto},
                                         {"replacePhoto", a.replacePhoto},
                                         {"removePhoto", a.removePhoto},
                                         {"rename", a.rename},
                                         {"shortcuts", a.shortcuts}});
    addView(rows, a);
    rows.add(ShortcutTexts::tr("Model"), {{"addRegion", a.addRegion},
                                          {"fixRegion", a.fixRegion},
                                          {"freeNodes", a.freeNodes},
                                          {"chooseDetail", a.chooseDetail},
                                          {"chooseInside", a.chooseInside},
                                          {"evenSheet", a.evenSheet},
                                          {"addPhoto", a.addPhoto},
                                          {"addPaint", a.addPaint},
                                          {"fromCamera", a.fromCamera}});
    rows.addOne(ShortcutTexts::tr("Simulation"), "play", ShortcutTexts::tr("Play or pause"), a.play);
    rows.add(ShortcutTexts::tr("Simulation"),
             {{"playScene", a.playScene}, {"reset", a.reset}, {"removeScene", a.removeScene}});
    rows.addNamed(ShortcutTexts::tr("Tools"), QStringLiteral("tool/"), a.tools->actions());
    rows.add(ShortcutTexts::tr("Tools"), {{"letGo", a.letGo}});
    rows.add(ShortcutTexts::tr("Help"), {{"firstSteps", a.firstSteps}, {"keys", a.keys}, {"about", a.about}});
    return rows.rows();
}

QString shownKeys(const QList<QKeySequence>& keys) {
    return QKeySequence::listToString(keys, QKeySequence::NativeText)
        .replace(QStringLiteral("; "), QStringLiteral(", "));
}

ShortcutKeys keysOf(const std::vector<ShortcutRow>& rows) {
    ShortcutKeys keys;
    for (const ShortcutRow& row : rows)
        keys[row.id] = row.action->shortcuts();
    return keys;
}

void giveKeys(const std::vector<ShortcutRow>& rows, const ShortcutKeys& keys) {
    for (const ShortcutRow& row : rows)
        if (row.action->shortcuts() != keys.at(row.id)) setKeys(row.action, keys.at(row.id));
}

void saveKeys(QSettings& settings, const ShortcutKeys& keys, const ShortcutKeys& usual) {
    settings.remove(shortcutsKey);
    settings.beginGroup(shortcutsKey);
    for (const auto& [id, own] : keys)
        if (own != usual.at(id)) settings.setValue(id, writtenKeys(own));
    settings.endGroup();
}

ShortcutKeys restoredKeys(const QSettings& settings, const std::vector<ShortcutRow>& rows,
                          const ShortcutKeys& usual) {
    ShortcutKeys keys = usual;
    for (auto& [id, own] : keys) {
        const QVariant stored = settings.value(shortcutsKey + '/' + id);
        if (const auto read = readKeys(stored.toString()); stored.isValid() && read) own = *read;
    }
    const auto isClaimed = [&](const QString& id, const QKeySequence& key) {
        return holderOf(rows, keys, key, id) != nullptr;
    };
    // Who changed his key gives way, to what he had before where nobody has that now.
    for (auto& [id, own] : keys) {
        const auto claimed = [&, &id = id](const QKeySequence& key) { return isClaimed(id, key); };
        if (own == usual.at(id) || std::none_of(own.begin(), own.end(), claimed)) continue;
        own = usual.at(id);
        own.erase(std::remove_if(own.begin(), own.end(), claimed), own.end());
    }
    return keys;
}

const ShortcutRow* holderOf(const std::vector<ShortcutRow>& rows, const ShortcutKeys& keys,
                            const QKeySequence& key, const QString& except) {
    const auto holds = [&](const ShortcutRow& row) {
        return row.id != except && keys.at(row.id).contains(key);
    };
    const auto found = std::find_if(rows.begin(), rows.end(), holds);
    return found == rows.end() ? nullptr : &*found;
}

QString keptFor(const QKeySequence& key) {
    const int modifiers = key[0] & int(Qt::KeyboardModifierMask), plain = key[0] & ~modifiers;
    switch (plain) {
    case Qt::Key_Left:
    case Qt::Key_Right:
    case Qt::Key_Up:
    case Qt::Key_Down:
    case Qt::Key_Return:
    case Qt::Key_Enter:
    case Qt::Key_PageUp:
    case Qt::Key_PageDown:
        return ShortcutTexts::tr("works in the view, in fields and in lists");
    case Qt::Key_Tab:
    case Qt::Key_Backtab:
        return ShortcutTexts::tr("goes from one control to the next");
    case Qt::Key_F2:
    case Qt::Key_Delete:
    case Qt::Key_Backspace:
        return ShortcutTexts::tr("renames or removes what is selected");
    case Qt::Key_BracketLeft:
    case Qt::Key_BracketRight:
        return ShortcutTexts::tr("sizes the brush");
    default:
        break;
    }
    const bool isLetter = plain >= Qt::Key_A && plain <= Qt::Key_Z;
    return isLetter && modifiers == Qt::AltModifier ? ShortcutTexts::tr("opens menus and goes to fields")
                                                    : QString();
}

QString whyNothingHappens(const std::vector<ShortcutRow>& rows, const QKeySequence& key) {
    const auto found = std::find_if(rows.begin(), rows.end(), [&](const ShortcutRow& row) {
        return !row.action->isEnabled() && row.action->shortcuts().contains(key);
    });
    return found == rows.end() ? QString() : found->action->toolTip();
}

QString withKeys(QString text, const Actions& actions) {
    if (!text.contains('{')) return text;
    for (const ShortcutRow& row : shortcutRows(actions)) {
        const QString key = row.action->shortcut().toString(QKeySequence::NativeText);
        const QString name = QStringLiteral("“%1”").arg(row.name);
        text.replace('{' + row.id + '}', key.isEmpty() ? name : key);
    }
    return text;
}

} // namespace esm
