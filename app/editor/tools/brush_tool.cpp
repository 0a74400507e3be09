#include "app/editor/tools/brush_tool.h"

#include "app/editor/tools/brush_panel.h"
#include "app/editor/tools/brush_path.h"
#include "widgets/view/brush_outline.h"

namespace esm {

namespace {

/// Share of the radius between the places where the surface is looked for. The painting leaves out half of
/// them: those that are kept lie half a radius apart at most.
constexpr double strokeSpacing = 0.25;

std::optional<PickedPoint> surfaceUnder(const ToolMouse& mouse) {
    const auto& mesh = mouse.sight.scene.mesh;
    return mesh && !mesh->triangles.empty() ? mouse.picked() : std::nullopt;
}

} // namespace

BrushTool::BrushTool(const ToolContext& context)
    : m_selection(context.selection), m_painting(context.document, context.selection, this) {
    connect(&m_painting, &Painting::changed, this, &BrushTool::changed);
    connect(&m_painting, &Painting::message, this, &BrushTool::message);
}

QWidget* BrushTool::makeOptions() {
    return new BrushPanel(m_painting);
}

Hold BrushTool::press(const ToolMouse& mouse) {
    lookAt(surfaceUnder(mouse));
    const auto point = brushPointAt(mouse.sight, mouse.place);
    if (mouse.keys.testFlag(Qt::ControlModifier)) {
        if (point) m_painting.setSource(*point);
        return Hold::Stroke;
    }
    if (!point) return Hold::Nothing;
    m_down = mouse.place;
    m_painting.begin(*point);
    return Hold::Stroke;
}

void BrushTool::move(const ToolMouse& mouse) {
    lookAt(surfaceUnder(mouse));
    if (!m_down) return;
    const double spacing = strokeSpacing * m_painting.brush().radius;
    m_painting.goOn(brushPointsAlong(mouse.sight, *m_down, mouse.place, spacing));
    m_down = mouse.place;
}

void BrushTool::release() {
    if (m_down) m_painting.finish();
    m_down.reset();
}

void BrushTool::cancel() {
    if (m_down) m_painting.drop();
    m_down.reset();
    lookAt(std::nullopt);
}

void BrushTool::leave() {
    lookAt(std::nullopt);
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
