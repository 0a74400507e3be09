#include "app/editor/window/start_controller.h"

#include <QDialog>
#include <QMenuBar>
#include <QStatusBar>
#include <QToolBar>

#include <algorithm>

namespace esm {

namespace {

bool isWorthOpening(const QMenu& menu) {
    const auto entries = menu.actions();
    return std::any_of(entries.begin(), entries.end(), [](const QAction* entry) {
        return entry->isVisible() && !entry->isSeparator() && !entry->menu();
    });
}

} // namespace

StartController::StartController(QMainWindow& window, QStackedWidget& pages, const Actions& actions,
                                 Workspaces& workspaces, FileController& files)
    : QObject(&window), m_window(window), m_pages(pages), m_actions(actions), m_workspaces(workspaces),
      m_files(files), m_page(new StartPage(actions)) {
    pages.addWidget(m_page);
    connect(m_page, &StartPage::recentChosen, &files, &FileController::openRecent);
}

void StartController::connectSteps(FirstSteps& steps) {
    const auto begin = [this, &steps] {
        if (!m_files.openSample("liver")) return;
        m_workspaces.choose(Workspace::Tissue);
        steps.begin();
    };
    connect(m_page, &StartPage::firstStepsAsked, &steps, begin);
    connect(m_actions.firstSteps, &QAction::triggered, &steps, begin);
}

void StartController::show() {
    m_actions.fuzzyWindow->setChecked(false);
    for (QDialog* beside : m_window.findChildren<QDialog*>(QString(), Qt::FindDirectChildrenOnly))
        beside->hide();
    m_pages.setCurrentWidget(m_page);
    setOrganActionsVisible(false);
    setBarsVisible(false);
    m_workspaces.hide();
    m_window.setWindowTitle(tr("Elastodynamic Shape Modeler"));
}

void StartController::leave() {
    if (!isShown()) return;
    m_pages.setCurrentIndex(0);
    setOrganActionsVisible(true);
    setBarsVisible(true);
    m_workspaces.show();
    emit left();
}

/// An action that is not to be seen does not answer its key either.
void StartController::setOrganActionsVisible(bool visible) {
    const Actions& a = m_actions;
    std::vector<const QAction*> useful{a.open,      a.import, a.quit,  a.lightTheme,
                                       a.shortcuts, a.keys,   a.about, a.firstSteps};
    for (const auto& sample : a.samples)
        useful.push_back(sample.second);
    for (QAction* action : {a.undo, a.redo})
        action->setVisible(visible);
    for (QAction* action : m_window.actions())
        if (std::find(useful.begin(), useful.end(), action) == useful.end()) action->setVisible(visible);
    for (QAction* menu : m_window.menuBar()->actions())
        menu->setVisible(isWorthOpening(*menu->menu()));
}

void StartController::setBarsVisible(bool visible) {
    for (QToolBar* bar : m_window.findChildren<QToolBar*>(QString(), Qt::FindDirectChildrenOnly))
        bar->setVisible(visible);
    m_window.statusBar()->setVisible(visible);
    m_window.menuBar()->cornerWidget(Qt::TopRightCorner)->setVisible(visible);
}

} // namespace esm
