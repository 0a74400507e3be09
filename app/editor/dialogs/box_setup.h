#pragma once

#include <QDialog>
#include <QMessageBox>

namespace esm {

/// Names a box, and lets each of its usual buttons but Discard be chosen by a letter, whatever the desktop.
/// Once the box has its buttons.
void setUpBox(QMessageBox& box, const char* name);

/// Escape closes an open list of the dialog, or else rejects it, whichever widget has the keys.
void rejectOnEscape(QDialog& dialog);

} // namespace esm
