#pragma once

#include "app/editor/window/file_controller.h"
#include "app/editor/window/first_steps.h"
#include "app/editor/window/start_page.h"
#include "app/editor/window/workspaces.h"

#include <QStackedWidget>

namespace esm {

/// The start page in place of all that needs an organ, until there is one; and the first steps with the
/// program.
class StartController : public QObject {
    Q_OBJECT

public:
    /// @param pages the middle of the window; its first page is what an organ needs
    StartController(QMainWindow& window, QStackedWidget& pages, const Actions& actions,
                    Workspaces& workspaces, FileController& files);

    void connectSteps(FirstSteps& steps);
    /// Puts the start page in place of what the window shows, and hides the windows beside it.
    void show();
    bool isShown() const { return m_pages.currentWidget() == m_page; }
    /// Nothing happens where the page is not shown.
    void leave();

signals:
    /// What the window shows is the organ again.
    void left();

private:
    void setOrganActionsVisible(bool visible);
    void setBarsVisible(bool visible);

    QMainWindow& m_window;
    QStackedWidget& m_pages;
    Actions m_actions;
    Workspaces& m_workspaces;
    FileController& m_files;
    StartPage* m_page;
};

} // namespace esm
