#pragma once

#include <QWidget>

namespace esm {

/// Lets focused controls keep the keys they answer themselves, where the window has a shortcut on the same
/// key: Space presses buttons and opens choices, Home and End move sliders, choices and lists.
void keepControlKeys(QWidget& window);

/// Lets a choice turn with the wheel only while it has the focus, so that a panel scrolls beneath the mouse.
void guardFromWheel(QWidget& control);

} // namespace esm
