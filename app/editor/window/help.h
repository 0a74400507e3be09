#pragma once

#include <QWidget>

namespace esm {

/// What mouse and keys do in the window.
void showKeys(QWidget* window);
void showAbout(QWidget* window);

} // namespace esm
