#pragma once

#include "app/editor/document/document.h"
#include "app/editor/document/selection.h"
#include "app/editor/edits/system_reach.h"
#include "widgets/inputs/section.h"

#include <QAction>
#include <QLayout>
#include <QTabBar>

namespace esm {

/// Where the fuzzy system of the selected region is read and edited, a tab for each way to look at it: in the
/// column, or in a window of its own, where there is room for long rules while the tissue is pulled at.
class FuzzyWorkbench : public Section {
    Q_OBJECT

public:
    FuzzyWorkbench(Document& document, Selection& selection, SystemReach& reach, QWidget* parent = nullptr);

    /// The checkable action that moves the tabs into the window and back.
    void setWindowAction(QAction* action);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void addTab(const QString& name, const QString& toolTip, QWidget* panel);
    void showTab(int index);
    void showSystem();
    void showName();
    void moveToWindow();
    void moveToColumn();

    Document& m_document;
    Selection& m_selection;
    QWidget* m_content;
    QLayout* m_pages; ///< what to do without a system, or the tabs
    QTabBar* m_tabs;
    QLayout* m_panels;
    QWidget* m_elsewhere; ///< in the content's place while that is in the window
    QWidget* m_window = nullptr;
    QAction* m_windowAction = nullptr;
    std::shared_ptr<const FuzzySystem> m_named; ///< the system that the title names
    QString m_name;
};

} // namespace esm
