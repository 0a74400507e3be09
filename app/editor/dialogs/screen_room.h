#pragma once

#include <QApplication>
#include <QWidget>

namespace esm {

/// The largest that a window may be on its screen, with room for its frame.
QSize roomOnScreen(const QWidget& window);

/// Makes dialogs and windows that stand beside the main one no larger than their screen, and moves those
/// that reach over its edge, whenever they are shown.
void keepWindowsOnScreen(QApplication& application);

} // namespace esm
