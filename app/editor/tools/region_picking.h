#pragma once

#include "app/editor/document/document.h"
#include "app/editor/document/selection.h"
#include "widgets/view/view_tool.h"

namespace esm {

/// Selects the region whose ellipsoid is the `drawn`th that is shown, and gives it: those that have one are
/// shown in the order of the project. Nothing where there is none.
std::optional<RegionId> selectDrawnRegion(const Document& document, Selection& selection, int drawn);

/// Selects the region whose ellipsoid lies under the mouse, where there is one.
void selectRegionUnder(const ToolMouse& mouse, const Document& document, Selection& selection);

} // namespace esm
