#pragma once

#include "app/editor/window/actions.h"

#include <QDockWidget>
#include <QMainWindow>

#include <vector>

namespace esm {

/// What stands around the view: menus and the columns of panels.
void buildMenus(QMainWindow& window, const Actions& actions);
/// What of the organ is shown, and its colours.
void fillShownMenu(QMenu* menu, const Actions& actions);

/// A scrolling column of panels at one side of the view.
QDockWidget* buildColumn(QMainWindow& window, Qt::DockWidgetArea side, const QString& title,
                         const std::vector<QWidget*>& panels);

/// Views that share the middle of the window, one above the other; a hidden one leaves it to the others.
QWidget* stacked(const std::vector<QWidget*>& views);

/// The same side by side where the room is wide, so that each is large: one above the other where it is high.
QWidget* beside(const std::vector<QWidget*>& views);

} // namespace esm
