#pragma once

#include <QStringList>
#include <QWidget>

/// What somebody misses who hears a window in place of seeing it, or who asks a control what it does: a line
/// for each visible widget that takes keys or clicks and has no name, no value, no tool tip or no letter of
/// its own.
QStringList accessComplaints(QWidget& window);
