#pragma once

#include <QIcon>
#include <QString>

namespace esm {

/// One of the project's line icons (`resources/icons/NAME.svg`), drawn in the colour of the application's
/// text, so that one drawing serves both themes; quiet when disabled, white when checked.
QIcon icon(const QString& name);

/// Makes the icons and the style sheet known to Qt; may be called again.
void loadResources();

} // namespace esm
