#include "app/editor/tools/region_picking.h"

#include "widgets/view/dragging.h"

namespace esm {

std::optional<RegionId> drawnRegion(const Document& document, int drawn) {
    for (const Region& region : document.project().regions)
        if (region.ellipsoid && drawn-- == 0) return region.id;
    return std::nullopt;
}

void selectRegionUnder(const ToolMouse& mouse, const Document& document, Selection& selection) {
    const auto region = drawnRegion(document, ellipsoidUnder(mouse.sight.scene, mouse.ray()));
    if (region) selection.setRegion(region);
}

} // namespace esm
