#pragma once

#include "app/editor/window/actions.h"
#include "core/project/editor_state.h"

#include <QDockWidget>
#include <QMainWindow>

#include <map>
#include <vector>

namespace esm {

/// The columns of panels beside the view, two for each workspace: those of one are shown, as far as the user
/// wants to see them.
class Workspaces : public QObject {
    Q_OBJECT

public:
    Workspaces(QMainWindow& window, const Actions& actions);

    /// Builds its columns of these panels, from the top.
    void add(Workspace workspace, const std::vector<QWidget*>& left, const std::vector<QWidget*>& right);
    /// Shows the one that is chosen, once all are added.
    void show();
    /// No column is to be seen until show().
    void hide();

    Workspace chosen() const;
    /// As the user does by its button.
    void choose(Workspace workspace);

signals:
    void shown(esm::Workspace workspace);

private:
    struct Columns {
        QDockWidget *left, *right;
    };

    QAction* actionOf(Workspace workspace) const;

    QMainWindow& m_window;
    Actions m_actions;
    std::map<Workspace, Columns> m_columns;
    bool m_isHidden = true;
};

} // namespace esm
