#pragma once

#include "app/editor/window/actions.h"
#include "core/project/editor_state.h"

#include <QDockWidget>
#include <QMainWindow>

#include <map>
#include <vector>

namespace esm {

/// The columns of panels beside the view: those of one workspace are shown, as far as the user wants to see
/// them. Columns at the right share their place as tabs. Where the window is too narrow for both sides, as on
/// a small screen or one with a display scale of 2, the left one joins them.
class Workspaces : public QObject {
    Q_OBJECT

public:
    Workspaces(QMainWindow& window, const Actions& actions);

    /// What a column is called, and its panels from the top.
    struct Column {
        QString name;
        std::vector<QWidget*> panels;
    };
    void add(Workspace workspace, const Column& left, const std::vector<Column>& right);
    /// Shows the one that is chosen, once all are added.
    void show();
    /// No column is to be seen until show().
    void hide();

    Workspace chosen() const;
    /// As the user does by its button.
    void choose(Workspace workspace);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

signals:
    void shown(esm::Workspace workspace);

private:
    struct Columns {
        QDockWidget* left;
        std::vector<QDockWidget*> right; ///< may be empty; the first lies in front
    };

    QAction* actionOf(Workspace workspace) const;
    void place(const Columns& columns);
    static void hide(const Columns& columns);
    void fitWindow();

    QMainWindow& m_window;
    Actions m_actions;
    std::map<Workspace, Columns> m_columns;
    bool m_isHidden = true, m_isNarrow = false;
};

} // namespace esm
