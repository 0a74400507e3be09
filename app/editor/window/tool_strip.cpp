#include "app/editor/window/tool_strip.h"

#include "app/editor/tools/tool_table.h"

#include <QCoreApplication>
#include <QLayout>

#include <algorithm>

namespace esm {

namespace {

constexpr int smallestSide = 24, usualSide = 34, stripWidth = 46;    // pixels
constexpr int usualIcon = 20, smallIcon = 16, sideOfSmallIcons = 28; // pixels; larger ones are cut

} // namespace

ToolStrip::ToolStrip(const Actions& actions, QWidget* parent) : QToolBar(tr("Tools"), parent) {
    setObjectName(QStringLiteral("toolStrip"));
    setOrientation(Qt::Vertical);
    setMovable(false);
    setContextMenuPolicy(Qt::PreventContextMenu);
    setIconSize({usualIcon, usualIcon});
    setFixedWidth(stripWidth);
    addTools(actions);
    // Its margins lie in the style sheet, which knows it by a name that it did not have when it was made.
    ensurePolished();
    QEvent named(QEvent::StyleChange);
    QCoreApplication::sendEvent(this, &named);
    setMinimumHeight(heightWithoutButtons() + static_cast<int>(m_buttons.size()) * smallestSide);
}

void ToolStrip::addTools(const Actions& actions) {
    // Those of every workspace come first.
    bool isEverywhere = true;
    for (const ToolRow& row : toolTable()) {
        if (isEverywhere && row.workspace != ToolWorkspace::Any) addSeparator();
        isEverywhere = row.workspace == ToolWorkspace::Any;
        QAction* tool = actions.tool(row.name);
        addAction(tool);
        m_buttons.push_back(qobject_cast<QToolButton*>(widgetForAction(tool)));
        m_buttons.back()->setFocusPolicy(Qt::TabFocus);
        m_buttons.back()->setFixedSize(usualSide, usualSide);
    }
    m_side = usualSide;
}

int ToolStrip::heightWithoutButtons() const {
    const QMargins around = layout()->contentsMargins();
    int height = around.top() + around.bottom() + layout()->spacing() * (layout()->count() - 1);
    for (QAction* action : actions())
        if (action->isSeparator()) height += widgetForAction(action)->sizeHint().height();
    return height;
}

void ToolStrip::resizeEvent(QResizeEvent* event) {
    const int room = (height() - heightWithoutButtons()) / static_cast<int>(m_buttons.size());
    const int side = std::clamp(room, smallestSide, usualSide);
    if (side != m_side) {
        m_side = side;
        const int shown = side < sideOfSmallIcons ? smallIcon : usualIcon;
        setIconSize({shown, shown});
        for (QToolButton* button : m_buttons)
            button->setFixedSize(side, side);
        layout()->activate();
    }
    QToolBar::resizeEvent(event);
}

} // namespace esm
