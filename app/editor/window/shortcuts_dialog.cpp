#include "app/editor/window/shortcuts_dialog.h"

#include "widgets/inputs/enabling.h"

#include <QAccessible>
#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QVBoxLayout>

#include <utility>

namespace esm {

namespace {

constexpr int placeRole = Qt::UserRole; ///< of a row among all

QString shownKey(const QKeySequence& key) {
    return key.toString(QKeySequence::NativeText);
}

} // namespace

ShortcutsDialog::ShortcutsDialog(std::vector<ShortcutRow> rows, const ShortcutKeys& usual, QWidget* parent)
    : QDialog(parent), m_rows(std::move(rows)), m_usual(usual), m_keys(keysOf(m_rows)),
      m_list(new QTreeWidget(this)), m_field(new KeyField(this)), m_message(new QLabel(this)),
      m_move(nullptr), m_clear(nullptr), m_reset(nullptr) {
    setObjectName(QStringLiteral("shortcutsDialog"));
    setWindowTitle(tr("Shortcuts"));
    setWindowFlag(Qt::WindowContextHelpButtonHint, false);
    resize(520, 640);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(20, 18, 20, 18);
    column->setSpacing(12);
    fillList();
    column->addWidget(m_list, 1);
    column->addWidget(makeEditor());
    m_message->setObjectName(QStringLiteral("shortcutMessage"));
    m_message->setProperty("warning", true);
    m_message->setWordWrap(true);
    m_message->setMinimumHeight(2 * m_message->fontMetrics().lineSpacing());
    m_message->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    column->addWidget(m_message);
    makeButtons();
    connect(m_list, &QTreeWidget::currentItemChanged, this, &ShortcutsDialog::chooseRow);
    connect(m_field, &KeyField::keyTyped, this, &ShortcutsDialog::take);
    m_list->setCurrentItem(m_list->topLevelItem(0)->child(0));
    m_list->setFocus();
}

void ShortcutsDialog::fillList() {
    m_list->setObjectName(QStringLiteral("shortcutList"));
    m_list->setAccessibleName(tr("Actions and their keys"));
    m_list->setToolTip(tr("Choose an action, then type its key below"));
    m_list->setHeaderLabels({tr("Action"), tr("Key")});
    m_list->headerItem()->setToolTip(0, tr("What is done, by the menu that it stands in"));
    m_list->headerItem()->setToolTip(1, tr("What does it; the first of several stands in tool tips"));
    m_list->header()->setSectionResizeMode(0, QHeaderView::Stretch);
    m_list->header()->setSectionsMovable(false);
    m_list->setUniformRowHeights(true);
    QTreeWidgetItem* group = nullptr;
    for (std::size_t i = 0; i < m_rows.size(); ++i) {
        if (!group || group->text(0) != m_rows[i].group) {
            group = new QTreeWidgetItem(m_list, {m_rows[i].group});
            group->setFlags(Qt::ItemIsEnabled);
            group->setExpanded(true);
        }
        auto* item = new QTreeWidgetItem(group, {m_rows[i].name});
        item->setData(0, placeRole, static_cast<int>(i));
        item->setToolTip(0, whatItDoes(m_rows[i].action));
    }
    showKeys();
}

QWidget* ShortcutsDialog::makeEditor() {
    auto* whole = new QWidget(this);
    auto* line = new QHBoxLayout(whole);
    line->setContentsMargins(0, 0, 0, 0);
    auto* caption = new QLabel(tr("&Key"), whole);
    caption->setProperty("quiet", true);
    caption->setBuddy(m_field);
    m_field->setObjectName(QStringLiteral("shortcutField"));
    m_field->setAccessibleName(tr("Key"));
    m_field->setToolTip(tr("Press the key, with Ctrl, Shift or Alt where they belong to it"));
    m_field->setPlaceholderText(tr("Press a key"));
    line->addWidget(caption);
    line->addWidget(m_field, 1);
    m_move = addButton(line, "moveShortcut", tr("&Move it here"), &ShortcutsDialog::moveHere);
    m_clear = addButton(line, "clearShortcut", tr("&No key"), &ShortcutsDialog::clearKey);
    m_reset = addButton(line, "resetShortcut", tr("&Reset"), &ShortcutsDialog::reset);
    return whole;
}

QPushButton* ShortcutsDialog::addButton(QLayout* row, const char* name, const QString& text,
                                        void (ShortcutsDialog::*does)()) {
    auto* button = new QPushButton(text, this);
    button->setObjectName(QLatin1String(name));
    button->setAutoDefault(false);
    row->addWidget(button);
    connect(button, &QPushButton::clicked, this, does);
    return button;
}

void ShortcutsDialog::makeButtons() {
    auto* row = new QHBoxLayout;
    QPushButton* all = addButton(row, "resetShortcuts", tr("Reset &all"), &ShortcutsDialog::resetAll);
    all->setToolTip(tr("Give every action the key that it had at first"));
    row->addStretch();
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    buttons->button(QDialogButtonBox::Ok)->setToolTip(tr("Use these keys from now on"));
    buttons->button(QDialogButtonBox::Cancel)->setToolTip(tr("Leave all keys as they were"));
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    row->addWidget(buttons);
    static_cast<QVBoxLayout*>(layout())->addLayout(row);
}

const ShortcutRow* ShortcutsDialog::row() const {
    const QTreeWidgetItem* item = m_list->currentItem();
    const QVariant place = item ? item->data(0, placeRole) : QVariant();
    return place.isValid() ? &m_rows[static_cast<std::size_t>(place.toInt())] : nullptr;
}

void ShortcutsDialog::chooseRow() {
    say({});
    showKeys();
}

void ShortcutsDialog::take(const QKeySequence& key) {
    const ShortcutRow* chosen = row();
    if (!chosen) return;
    if (const QString kept = keptFor(key); !kept.isEmpty()) {
        say(tr("%1 cannot be a shortcut: it %2.").arg(shownKey(key), kept));
    } else if (const ShortcutRow* holder = holderOf(m_rows, m_keys, key, chosen->id)) {
        say(tr("%1 is the key of “%2” in the menu %3.").arg(shownKey(key), holder->name, holder->group), key);
    } else {
        say({});
        return setKeysOfRow({key});
    }
    showKeys();
}

void ShortcutsDialog::moveHere() {
    const ShortcutRow* chosen = row();
    if (!chosen || m_wanted.isEmpty()) return;
    const QKeySequence key = m_wanted;
    if (const ShortcutRow* holder = holderOf(m_rows, m_keys, key, chosen->id)) {
        m_keys[holder->id].removeAll(key);
        say(m_keys[holder->id].isEmpty() ? tr("“%1” has no key now.").arg(holder->name) : QString());
    }
    setKeysOfRow({key});
}

void ShortcutsDialog::clearKey() {
    say({});
    setKeysOfRow({});
}

/// A key that another action was given meanwhile stays there.
void ShortcutsDialog::reset() {
    const ShortcutRow* chosen = row();
    if (!chosen) return;
    QList<QKeySequence> free;
    say({});
    for (const QKeySequence& key : m_usual.at(chosen->id)) {
        const ShortcutRow* holder = holderOf(m_rows, m_keys, key, chosen->id);
        if (!holder)
            free << key;
        else
            say(tr("%1 is the key of “%2” in the menu %3.").arg(shownKey(key), holder->name, holder->group),
                key);
    }
    setKeysOfRow(free);
}

void ShortcutsDialog::resetAll() {
    say({});
    m_keys = m_usual;
    showKeys();
}

void ShortcutsDialog::setKeysOfRow(const QList<QKeySequence>& keys) {
    if (const ShortcutRow* chosen = row()) m_keys[chosen->id] = keys;
    showKeys();
}

void ShortcutsDialog::say(const QString& message, const QKeySequence& wanted) {
    m_wanted = wanted;
    m_message->setText(message);
    if (message.isEmpty()) return;
    QAccessibleEvent told(m_message, QAccessible::Alert);
    QAccessible::updateAccessibility(&told);
}

void ShortcutsDialog::showKeys() {
    for (QTreeWidgetItemIterator at(m_list); *at; ++at) {
        const QVariant place = (*at)->data(0, placeRole);
        if (!place.isValid()) continue;
        const QString keys = shownKeys(m_keys.at(m_rows[static_cast<std::size_t>(place.toInt())].id));
        (*at)->setText(1, keys);
        (*at)->setToolTip(1, keys);
        (*at)->setData(0, Qt::AccessibleTextRole,
                       (*at)->text(0) + QStringLiteral(", ") + (keys.isEmpty() ? tr("no key") : keys));
    }
    if (!m_reset) return;
    const ShortcutRow* chosen = row();
    const QList<QKeySequence> own = chosen ? m_keys.at(chosen->id) : QList<QKeySequence>();
    const QString none = tr("Choose an action first");
    m_field->setEnabled(chosen);
    m_field->setKey(own.isEmpty() ? QKeySequence() : own.front());
    enable(m_move, !m_wanted.isEmpty(), tr("Take the key from the other action"),
           tr("No other action has the key"));
    enable(m_clear, !own.isEmpty(), tr("Let the action have no key"), chosen ? tr("It has no key") : none);
    enable(m_reset, chosen && own != m_usual.at(chosen->id), tr("The key that the action had at first"),
           chosen ? tr("The action has the key that it had at first") : none);
}

} // namespace esm
