#include "app/editor/panels/layers_panel.h"

#include "widgets/inputs/enabling.h"
#include "widgets/inputs/icon.h"

#include <QMenu>

namespace esm {

LayersPanel::LayersPanel(const QString& title, QPalette::ColorRole mark, ToolTips toolTips, QWidget* parent)
    : Section(title, parent), m_toolTips(std::move(toolTips)), m_list(new ItemList(mark, this)) {
    m_up = addHeaderIcon(icon(QStringLiteral("up")), m_toolTips.up);
    m_down = addHeaderIcon(icon(QStringLiteral("down")), m_toolTips.down);
    m_remove = addHeaderIcon(icon(QStringLiteral("remove")), m_toolTips.remove);
    m_add = addHeaderButton(tr("+ add"), tr("Add"));
    m_list->setAccessibleName(title);
    m_list->setToolTip(
        tr("F2 or a double click renames, Del removes, Ctrl with Up or Down changes the order, "
           "the right button offers more"));
    m_list->setContextMenuPolicy(Qt::CustomContextMenu);
    body()->addWidget(m_list);

    connect(m_up, &QToolButton::clicked, this, [this] { move(1); });
    connect(m_down, &QToolButton::clicked, this, [this] { move(-1); });
    connect(m_remove, &QToolButton::clicked, this, &LayersPanel::removeSelected);
    connect(m_list, &ItemList::customContextMenuRequested, this, &LayersPanel::showMenu);
    connect(m_list, &ItemList::removeRequested, this, &LayersPanel::removeSelected);
    connect(m_list, &ItemList::moveRequested, this, &LayersPanel::moveRow);
    connect(m_list, &ItemList::rowRenamed, this, &LayersPanel::rename);
    connect(m_list, &ItemList::rowSelected, this, [this](int row) { selectLayer(layerOf(row)); });
}

void LayersPanel::setAddAction(QAction* action) {
    follow(m_add, action);
}

void LayersPanel::showButtons(const Obstacles& obstacles) {
    enable(m_up, obstacles.up.isEmpty(), m_toolTips.up, obstacles.up);
    enable(m_down, obstacles.down.isEmpty(), m_toolTips.down, obstacles.down);
    enable(m_remove, obstacles.remove.isEmpty(), m_toolTips.remove, obstacles.remove);
}

namespace {

/// An entry that does what a button does, and can be chosen when that can.
void addEntry(QMenu& menu, const QString& text, QToolButton* button) {
    QAction* entry = menu.addAction(text, button, &QToolButton::click);
    entry->setEnabled(button->isEnabled());
    entry->setToolTip(button->toolTip());
}

} // namespace

void LayersPanel::showMenu(const QPoint& place) {
    const int row = m_list->currentRow();
    if (!layerOf(row)) return;
    // Of the key for menus the place says nothing.
    const bool isOnRow = m_list->indexAt(place).row() == row;
    const QPoint at = isOnRow ? place : m_list->visualItemRect(m_list->item(row)).center();
    QMenu menu(this);
    menu.setObjectName(QStringLiteral("layerMenu"));
    menu.setToolTipsVisible(true);
    menu.addAction(tr("Rena&me"), m_list, [this, row] { m_list->editItem(m_list->item(row)); })
        ->setToolTip(tr("Give it another name (F2)"));
    menu.addActions(m_menuActions);
    menu.addSeparator();
    addEntry(menu, tr("Move &up"), m_up);
    addEntry(menu, tr("Move do&wn"), m_down);
    menu.addSeparator();
    addEntry(menu, tr("&Remove"), m_remove);
    menu.exec(m_list->viewport()->mapToGlobal(at));
}

std::optional<std::size_t> LayersPanel::layerOf(int row) const {
    if (row < 0 || static_cast<std::size_t>(row) >= layerCount()) return std::nullopt;
    return layerCount() - 1 - static_cast<std::size_t>(row);
}

void LayersPanel::move(int above) {
    const auto selected = selectedLayer();
    if (!selected || !canMoveLayer(*selected, above)) return;
    moveLayer(*selected, above);
}

void LayersPanel::moveRow(int row, int to) {
    const auto layer = layerOf(row);
    if (!layer) return;
    selectLayer(layer);
    // As far as it may go: what always lies beneath stays there.
    int above = row - to;
    while (above != 0 && !canMoveLayer(*layer, above))
        above += above > 0 ? -1 : 1;
    if (above != 0) move(above);
}

void LayersPanel::removeSelected() {
    if (const auto selected = selectedLayer()) removeLayer(*selected);
}

void LayersPanel::rename(int row, const QString& name) {
    const auto layer = layerOf(row);
    const QString told = name.trimmed();
    if (layer && !told.isEmpty()) renameLayer(*layer, told.toStdString());
    // An empty name was not taken: the old one comes back.
    QMetaObject::invokeMethod(
        this, [this] { show(); }, Qt::QueuedConnection);
}

} // namespace esm
