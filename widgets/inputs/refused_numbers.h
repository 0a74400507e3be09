#pragma once

#include <QWidget>

namespace esm {

/// Asked before a window acts by the numbers in it: what is still being typed counts, and the first number
/// that was refused gets the focus and says why it was. Fields that are hidden or disabled do not matter.
/// @return whether every number was taken
bool takesAllNumbers(QWidget& window);

} // namespace esm
