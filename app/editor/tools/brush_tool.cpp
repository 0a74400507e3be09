#include "app/editor/tools/brush_tool.h"

#include "app/editor/tools/brush_panel.h"
#include "widgets/view/brush_outline.h"

namespace esm {

BrushTool::BrushTool(const ToolContext& context)
    : m_selection(context.selection), m_painting(context.document, context.selection, this) {
    connect(&m_painting, &Painting::changed, this, &BrushTool::changed);
    connect(&m_painting, &Painting::message, this, &BrushTool::message);
}

QWidget* BrushTool::makeOptions() {
    return new BrushPanel(m_painting);
}

Hold BrushTool::press(const ToolMouse& mouse) {
    const auto point = pointAt(mouse);
    if (mouse.keys.testFlag(Qt::ControlModifier)) {
        if (point) m_painting.setSource(*point);
        return Hold::Stroke;
    }
    if (!point) return Hold::Nothing;
    m_isDown = true;
    m_painting.begin(*point);
    return Hold::Stroke;
}

void BrushTool::move(const ToolMouse& mouse) {
    const auto point = pointAt(mouse);
    if (m_isDown && point) m_painting.goOn(*point);
}

void BrushTool::release() {
    if (m_isDown) m_painting.finish();
    m_isDown = false;
}

void BrushTool::cancel() {
    if (m_isDown) m_painting.drop();
    m_isDown = false;
    lookAt(std::nullopt);
}

void BrushTool::leave() {
    lookAt(std::nullopt);
}

std::optional<BrushPoint> BrushTool::pointAt(const ToolMouse& mouse) {
    const auto& mesh = mouse.sight.scene.mesh;
    lookAt(mesh && !mesh->triangles.empty() ? mouse.picked() : std::nullopt);
    if (!m_at || m_at->normal.isZero()) return std::nullopt;
    return BrushPoint{m_at->spot.point, m_at->normal};
}

void BrushTool::lookAt(const std::optional<PickedPoint>& point) {
    m_at = point;
    emit changed();
}

void BrushTool::draw(QPainter& painter, const Sight& sight, const QPalette&) const {
    const Painting::Brush brush = m_painting.brush();
    if (brush.kind == BrushKind::Clone && m_painting.source())
        if (const auto place = sight.placeOf(*m_painting.source())) paintSource(painter, *place);
    if (!m_at) return;
    const auto circle = [&](double radius) {
        return sight.placesOf(circleAround(m_at->point, m_at->spot.outward, radius));
    };
    paintBrush(painter, circle(brush.radius), circle((1 - brush.softness) * brush.radius));
}

} // namespace esm
