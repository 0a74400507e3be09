#pragma once

#include "app/editor/window/actions.h"

#include <QBoxLayout>
#include <QToolBar>

#include <vector>

namespace esm {

/// Undo, redo and the options of the tool in hand at the left, workspaces in the middle, playing and handing
/// over at the right. In a narrow window the options stand in a row of their own beneath.
class TopBar : public QToolBar {
    Q_OBJECT

public:
    TopBar(const Actions& actions, const std::vector<QWidget*>& toolOptions, QWidget* parent);

protected:
    void resizeEvent(QResizeEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    QHBoxLayout* addSide(QWidget* content);
    void addOptions(const std::vector<QWidget*>& toolOptions);
    /// Where the options stand goes by the room that there is for them.
    void arrange();

    QVBoxLayout* m_rows;
    QHBoxLayout *m_row, *m_left;
    QWidget *m_workspaces, *m_options;
    std::vector<QWidget*> m_toolOptions;
};

} // namespace esm
