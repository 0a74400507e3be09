#pragma once

#include "app/editor/document/document.h"

namespace esm {

/// Hides a layer that is shown, and shows one that is hidden. Nothing where it is not there.
void showOrHide(Document& document, LayerId layer);

/// Adds a copy of a layer just above it. Nothing where it is not there.
void duplicateLayer(Document& document, LayerId layer);

} // namespace esm
