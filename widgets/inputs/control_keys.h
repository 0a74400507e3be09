#pragma once

#include <QKeyEvent>
#include <QWidget>

namespace esm {

/// Lets focused controls keep the keys they answer themselves, where the window has a shortcut on the same
/// key: Space presses buttons and opens choices, Home and End move sliders, choices and lists.
void keepControlKeys(QWidget& window);

/// Gives the keys to `home` whenever no control of the window needs them: after Enter in a field whose text
/// was taken, after a choice from a list or a click on a button or a tab, and where the window comes to the
/// front with none that has them.
/// Call it once the window has its controls.
void giveKeysHome(QWidget& window, QWidget& home);

/// The desktop's key for redoing, and Ctrl+Y on every desktop.
bool isRedo(const QKeyEvent& key);

enum class Turning { WithFocus, Never };
/// Lets a choice turn with the wheel only while it has the focus, or not at all, so that a panel scrolls
/// beneath the mouse.
void guardFromWheel(QWidget& control, Turning turning = Turning::WithFocus);

} // namespace esm
