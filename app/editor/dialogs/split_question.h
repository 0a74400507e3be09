#pragma once

#include "core/model/scene.h"

#include <QWidget>

namespace esm {

/// Asks whether the scene's splits may go, as they must where other nodes are simulated. True where it has
/// none.
bool mayRemoveSplits(QWidget& window, const Scene& scene);

} // namespace esm
