#pragma once

#include "app/editor/workers/imported_surface.h"

#include <QStringList>

namespace esm {

/// What was repaired in a surface and what it means for the organ, a sentence each; never empty.
QStringList reportLines(const ImportedSurface& surface);

} // namespace esm
