#include "app/editor/tools/pull_tool.h"

#include "widgets/view/dragging.h"
#include "widgets/view/overlay.h"

namespace esm {

PullTool::PullTool(const ToolContext& context) : m_preview(context.preview) {
    connect(&m_preview, &Preview::statusChanged, this, &PullTool::changed);
    connect(&m_preview, &Preview::frameReady, this, [this] {
        if (m_drag) emit changed();
    });
}

Hold PullTool::press(const ToolMouse& mouse) {
    const std::optional<PickedPoint> picked = mouse.picked();
    if (!picked) return Hold::Nothing;
    m_drag = Drag{picked->node, picturePlane(mouse.sight.camera, picked->point),
                  picked->nodePosition - picked->point};
    m_preview.setGentleMotion(false);
    return Hold::Drag;
}

void PullTool::move(const ToolMouse& mouse) {
    if (!m_drag) return;
    const auto point = meet(mouse.ray(), m_drag->plane);
    if (point) m_preview.setPull(Pull{m_drag->node, *point + m_drag->nodeOffset});
}

void PullTool::release() {
    if (!m_drag) return;
    m_drag.reset();
    m_preview.setPull(std::nullopt);
    emit changed();
}

void PullTool::draw(QPainter& painter, const Sight& sight, const QPalette& palette) const {
    const std::optional<FeltTissue> felt = m_drag ? m_preview.status().pull : std::nullopt;
    const auto& nodes = sight.scene.nodePositions;
    if (!felt || m_drag->node >= nodes.size()) return;
    if (const auto place = sight.placeOf(nodes[m_drag->node]))
        paintLabel(painter, *place, feltText(*felt), palette);
}

} // namespace esm
