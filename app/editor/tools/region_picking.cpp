#include "app/editor/tools/region_picking.h"

#include "widgets/view/dragging.h"

namespace esm {

std::optional<RegionId> selectDrawnRegion(const Document& document, Selection& selection, int drawn) {
    for (const Region& region : document.project().regions) {
        if (!region.ellipsoid || drawn-- != 0) continue;
        selection.setRegion(region.id);
        return region.id;
    }
    return std::nullopt;
}

void selectRegionUnder(const ToolMouse& mouse, const Document& document, Selection& selection) {
    selectDrawnRegion(document, selection, ellipsoidUnder(mouse.sight.scene, mouse.ray()));
}

} // namespace esm
