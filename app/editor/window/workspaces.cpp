#include "app/editor/window/workspaces.h"

#include "app/editor/window/layout.h"

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
    for (QAction* action : {actions.tissue, actions.texture, actions.showLeft, actions.showRight})
        connect(action, &QAction::toggled, this, follow);
    connect(actions.tissue, &QAction::triggered, actions.tool(QStringLiteral("pull")), &QAction::trigger);
    // An action that cannot be used can still be triggered from here.
    connect(actions.texture, &QAction::triggered, this, [this] {
        QAction* projector = m_actions.tool(QStringLiteral("projector"));
        (projector->isEnabled() ? projector : m_actions.tool(QStringLiteral("look")))->trigger();
    });
}

void Workspaces::add(Workspace workspace, const Column& left, const Column& right) {
    m_columns[workspace] = {buildColumn(m_window, Qt::LeftDockWidgetArea, left.name, left.panels),
                            buildColumn(m_window, Qt::RightDockWidgetArea, right.name, right.panels)};
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
    m_window.removeDockWidget(columns.left);
    if (m_isNarrow)
        m_window.tabifyDockWidget(columns.right, columns.left);
    else
        m_window.addDockWidget(Qt::LeftDockWidgetArea, columns.left);
}

void Workspaces::show() {
    m_isHidden = false;
    for (const auto& [workspace, columns] : m_columns)
        if (workspace != chosen()) {
            columns.left->hide();
            columns.right->hide();
        }
    const Columns& columns = m_columns.at(chosen());
    columns.left->setVisible(m_actions.showLeft->isChecked());
    columns.right->setVisible(m_actions.showRight->isChecked());
    // The columns of all workspaces keep one width.
    if (m_isNarrow)
        m_window.resizeDocks({columns.right}, {rightWidth}, Qt::Horizontal);
    else
        m_window.resizeDocks({columns.left, columns.right}, {leftWidth, rightWidth}, Qt::Horizontal);
    columns.right->raise();
    emit shown(chosen());
}

void Workspaces::hide() {
    m_isHidden = true;
    for (const auto& [workspace, columns] : m_columns) {
        columns.left->hide();
        columns.right->hide();
    }
}

Workspace Workspaces::chosen() const {
    return m_actions.texture->isChecked() ? Workspace::Texture : Workspace::Tissue;
}

void Workspaces::choose(Workspace workspace) {
    actionOf(workspace)->trigger();
}

QAction* Workspaces::actionOf(Workspace workspace) const {
    return workspace == Workspace::Texture ? m_actions.texture : m_actions.tissue;
}

} // namespace esm
