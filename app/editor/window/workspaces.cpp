#include "app/editor/window/workspaces.h"

#include "app/editor/window/layout.h"

#include <QEvent>

namespace esm {

namespace {

constexpr int leftWidth = 276, rightWidth = 340; // pixels
constexpr int narrowestMiddle = 400;             // pixels, for the tools and a view that can be worked in

} // namespace

Workspaces::Workspaces(QMainWindow& window, const Actions& actions)
    : QObject(&window), m_window(window), m_actions(actions) {
    window.setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
    window.setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
    window.setTabPosition(Qt::AllDockWidgetAreas, QTabWidget::North);
    window.installEventFilter(this);
    const auto follow = [this] {
        if (!m_isHidden) show();
    };
    for (QAction* action :
         {actions.tissue, actions.texture, actions.measure, actions.showLeft, actions.showRight})
        connect(action, &QAction::toggled, this, follow);
    connect(actions.tissue, &QAction::triggered, actions.tool(QStringLiteral("pull")), &QAction::trigger);
    // An action that cannot be used can still be triggered from here.
    connect(actions.texture, &QAction::triggered, this, [this] {
        QAction* projector = m_actions.tool(QStringLiteral("projector"));
        (projector->isEnabled() ? projector : m_actions.tool(QStringLiteral("look")))->trigger();
    });
}

void Workspaces::add(Workspace workspace, const Column& left, const std::vector<Column>& right) {
    Columns columns{buildColumn(m_window, Qt::LeftDockWidgetArea, left.name, left.panels), {}};
    for (const Column& column : right) {
        columns.right.push_back(buildColumn(m_window, Qt::RightDockWidgetArea, column.name, column.panels));
        if (columns.right.size() > 1) m_window.tabifyDockWidget(columns.right.front(), columns.right.back());
    }
    m_columns[workspace] = std::move(columns);
}

bool Workspaces::eventFilter(QObject*, QEvent* event) {
    if (event->type() == QEvent::Resize) fitWindow();
    return false;
}

void Workspaces::fitWindow() {
    const bool isNarrow = m_window.width() < leftWidth + rightWidth + narrowestMiddle;
    if (isNarrow == m_isNarrow) return;
    m_isNarrow = isNarrow;
    for (const auto& [workspace, columns] : m_columns)
        place(columns);
    if (!m_isHidden) show();
}

void Workspaces::place(const Columns& columns) {
    if (columns.right.empty()) return;
    m_window.removeDockWidget(columns.left);
    if (m_isNarrow)
        m_window.tabifyDockWidget(columns.right.front(), columns.left);
    else
        m_window.addDockWidget(Qt::LeftDockWidgetArea, columns.left);
}

void Workspaces::show() {
    m_isHidden = false;
    for (const auto& [workspace, columns] : m_columns)
        if (workspace != chosen()) hide(columns);
    const Columns& columns = m_columns.at(chosen());
    columns.left->setVisible(m_actions.showLeft->isChecked());
    for (QDockWidget* column : columns.right)
        column->setVisible(m_actions.showRight->isChecked());
    // The columns of all workspaces keep one width.
    if (!m_isNarrow || columns.right.empty())
        m_window.resizeDocks({columns.left}, {leftWidth}, Qt::Horizontal);
    if (!columns.right.empty()) {
        m_window.resizeDocks({columns.right.front()}, {rightWidth}, Qt::Horizontal);
        columns.right.front()->raise();
    }
    emit shown(chosen());
}

void Workspaces::hide(const Columns& columns) {
    columns.left->hide();
    for (QDockWidget* column : columns.right)
        column->hide();
}

void Workspaces::hide() {
    m_isHidden = true;
    for (const auto& [workspace, columns] : m_columns)
        hide(columns);
}

Workspace Workspaces::chosen() const {
    if (m_actions.measure->isChecked()) return Workspace::Measure;
    return m_actions.texture->isChecked() ? Workspace::Texture : Workspace::Tissue;
}

void Workspaces::choose(Workspace workspace) {
    actionOf(workspace)->trigger();
}

QAction* Workspaces::actionOf(Workspace workspace) const {
    switch (workspace) {
    case Workspace::Texture:
        return m_actions.texture;
    case Workspace::Measure:
        return m_actions.measure;
    default:
        return m_actions.tissue;
    }
}

} // namespace esm
