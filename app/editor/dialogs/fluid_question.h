#pragma once

#include "core/model/detail.h"
#include "core/model/scene.h"

#include <QWidget>

namespace esm {

/// Asks whether the fluid in the organ's parts may go, as it must where a lattice fills the body, and within
/// a wall of prisms. True where
/// there is none, or the organ stays hollow.
bool mayRemoveFluids(QWidget& window, const Scene& scene, const Detail& chosen);

} // namespace esm
