#pragma once

#include "app/editor/window/actions.h"

#include <QDockWidget>
#include <QMainWindow>
#include <QPushButton>

#include <vector>

namespace esm {

/// What stands around the view: menus, the bar on top, the strip of tools, and the columns of panels.
void buildMenus(QMainWindow& window, const Actions& actions);
/// What of the organ is shown, and its colours.
void fillShownMenu(QMenu* menu, const Actions& actions);
void buildToolStrip(QMainWindow& window, const Actions& actions);

/// Undo, redo and the options of the tool in hand at the left, workspaces in the middle, playing and handing
/// over at the right.
void buildTopBar(QMainWindow& window, const Actions& actions, const std::vector<QWidget*>& toolOptions);

/// A scrolling column of panels at one side of the view.
QDockWidget* buildColumn(QMainWindow& window, Qt::DockWidgetArea side, const QString& title,
                         const std::vector<QWidget*>& panels);

/// Views that share the middle of the window, one above the other; a hidden one leaves it to the others.
QWidget* stacked(const std::vector<QWidget*>& views);

} // namespace esm
