#pragma once

#include "app/editor/document/document.h"
#include "app/editor/document/selection.h"
#include "widgets/view/view_tool.h"

namespace esm {

/// The region whose ellipsoid is the `drawn`th that is shown: those that have one are shown in the order of
/// the project. None where there is none.
std::optional<RegionId> drawnRegion(const Document& document, int drawn);

/// Selects the region whose ellipsoid lies under the mouse, where there is one.
void selectRegionUnder(const ToolMouse& mouse, const Document& document, Selection& selection);

} // namespace esm
