#include "app/editor/tools/region_picking.h"

#include "widgets/view/dragging.h"

namespace esm {

std::optional<std::size_t> selectDrawnRegion(const Document& document, Selection& selection, int drawn) {
    const auto& regions = document.project().regions;
    for (std::size_t i = 0; i < regions.size(); ++i) {
        if (!regions[i].ellipsoid || drawn-- != 0) continue;
        selection.setRegion(i);
        return i;
    }
    return std::nullopt;
}

void selectRegionUnder(const ToolMouse& mouse, const Document& document, Selection& selection) {
    selectDrawnRegion(document, selection, ellipsoidUnder(mouse.sight.scene, mouse.ray()));
}

} // namespace esm
