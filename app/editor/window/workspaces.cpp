#include "app/editor/window/workspaces.h"

#include "app/editor/window/layout.h"

namespace esm {

namespace {

constexpr int leftWidth = 276, rightWidth = 340; // pixels

} // namespace

Workspaces::Workspaces(QMainWindow& window, const Actions& actions)
    : QObject(&window), m_window(window), m_actions(actions) {
    window.setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
    window.setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
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

void Workspaces::add(Workspace workspace, const std::vector<QWidget*>& left,
                     const std::vector<QWidget*>& right) {
    const QString name = actionOf(workspace)->text().remove('&');
    m_columns[workspace] = {buildColumn(m_window, Qt::LeftDockWidgetArea, tr("%1, left").arg(name), left),
                            buildColumn(m_window, Qt::RightDockWidgetArea, tr("%1, right").arg(name), right)};
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
    m_window.resizeDocks({columns.left, columns.right}, {leftWidth, rightWidth}, Qt::Horizontal);
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
