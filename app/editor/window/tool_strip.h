#pragma once

#include "app/editor/window/actions.h"

#include <QToolBar>
#include <QToolButton>

#include <vector>

namespace esm {

/// The tools, one below the other. In a low window the buttons get smaller, so that all stay in sight.
class ToolStrip : public QToolBar {
    Q_OBJECT

public:
    ToolStrip(const Actions& actions, QWidget* parent);

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void addTools(const Actions& actions);
    /// What lies between and around the buttons, in pixels.
    int heightWithoutButtons() const;

    std::vector<QToolButton*> m_buttons;
    int m_side = 0; ///< of a button, in pixels
};

} // namespace esm
