#pragma once

#include "app/editor/document/document.h"

namespace esm {

/// Sets inputs of a region's fuzzy system, an edit that goes on until Document::finishGesture(). Nothing
/// happens without inputs.
void editInputs(Document& document, RegionId region, const NamedValues& inputs);

} // namespace esm
