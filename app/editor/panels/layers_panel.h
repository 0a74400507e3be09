#pragma once

#include "widgets/inputs/item_list.h"
#include "widgets/inputs/section.h"

#include <cstddef>
#include <optional>

class QAction;

namespace esm {

/// What the lists of regions and of photos share: layers that lie over each other, the topmost first, one of
/// them selected; they are moved, renamed and removed, by buttons, keys and a menu, and one more is added by
/// an action.
class LayersPanel : public Section {
    Q_OBJECT

public:
    /// What the button "+ add" does.
    void setAddAction(QAction* action);
    /// What else the menu of the selected layer offers.
    void setMenuActions(const QList<QAction*>& actions) { m_menuActions = actions; }

protected:
    /// What the buttons do.
    struct ToolTips {
        QString up, down, remove;
    };
    /// Why they cannot do it now; empty when they can.
    struct Obstacles {
        QString up, down, remove;
    };

    LayersPanel(const QString& title, QPalette::ColorRole mark, ToolTips toolTips, QWidget* parent);

    ItemList* list() const { return m_list; }
    void showButtons(const Obstacles& obstacles);
    int rowOf(std::size_t layer) const { return static_cast<int>(layerCount() - 1 - layer); }

    virtual void show() = 0;
    virtual std::size_t layerCount() const = 0;
    virtual std::optional<std::size_t> selectedLayer() const = 0;
    virtual void selectLayer(std::optional<std::size_t> layer) = 0;
    /// Over so many of those above it, or under those below it where `above` is below zero.
    virtual bool canMoveLayer(std::size_t layer, int above) const = 0;
    virtual void moveLayer(std::size_t layer, int above) = 0;
    virtual void removeLayer(std::size_t layer) = 0;
    virtual void renameLayer(std::size_t layer, const std::string& name) = 0;

    std::optional<std::size_t> layerOf(int row) const;

private:
    void showMenu(const QPoint& place);
    void move(int above);
    void moveRow(int row, int to);
    void removeSelected();
    void rename(int row, const QString& name);

    ToolTips m_toolTips;
    ItemList* m_list;
    QList<QAction*> m_menuActions;
    QToolButton *m_up, *m_down, *m_remove, *m_add;
};

} // namespace esm
