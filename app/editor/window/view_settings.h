#pragma once

#include "app/editor/window/actions.h"

#include <QSettings>

namespace esm {

/// What the view shows and how, as the user left it. A cut is not remembered: who opens the program wants to
/// see the organ.
void saveView(QSettings& settings, const Actions& actions);
void restoreView(const QSettings& settings, const Actions& actions);

} // namespace esm
