#pragma once

#include "app/editor/window/actions.h"

#include <QWidget>

namespace esm {

enum class SheetColumns { One, Two };

/// What mouse and keys do in the window: a table that is made of the tools' own hints and the actions' own
/// keys.
QString keysText(const Actions& actions, SheetColumns columns);
void showKeys(QWidget* window, const Actions& actions);
void showAbout(QWidget* window);

} // namespace esm
