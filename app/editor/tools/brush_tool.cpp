#include "app/editor/tools/brush_tool.h"

#include "app/editor/tools/brush_panel.h"
#include "widgets/view/brush_outline.h"

#include <algorithm>

namespace esm {

namespace {

/// Share of the radius between the places where the surface is looked for. The painting leaves out half of
/// them: those that are kept lie half a radius apart at most.
constexpr double strokeSpacing = 0.25;

/// A pen tells its pressure at few places of a fast stroke, as it does where it is.
std::optional<double> pressureBetween(std::optional<double> from, std::optional<double> to, double share) {
    return from && to ? *from + share * (*to - *from) : to;
}

/// Nothing of a brush that paints.
QString eraserUse(BrushKind kind, bool isPhoto) {
    if (kind == BrushKind::Restore) return BrushTool::tr("Drag over the organ to bring back what was erased");
    if (kind != BrushKind::Erase) return {};
    return isPhoto ? BrushTool::tr("Drag over the organ to erase the photo there")
                   : BrushTool::tr("Drag over the organ to erase the paint there");
}

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

QString BrushTool::hint() const {
    const TextureLayer* layer = m_painting.layer();
    const QString use = layer ? eraserUse(m_painting.brush().kind, layer->photo != nullptr) : QString();
    return use.isEmpty() ? use : use + tr(" · [ and ] size the brush · Esc drops the stroke");
}

Hold BrushTool::press(const ToolMouse& mouse) {
    lookAt(surfaceUnder(mouse));
    const auto point = brushPointAt(mouse.sight, mouse.place);
    if (mouse.keys.testFlag(Qt::ControlModifier)) {
        if (point) m_painting.setSource(*point);
        return Hold::Stroke;
    }
    if (!point && !isNearSurface(mouse.sight, mouse.place)) return Hold::Nothing;
    m_down = Down{MouseWay(mouse.place), mouse.pressure, point.has_value()};
    if (point) m_painting.begin({*point, mouse.pressure});
    return Hold::Stroke;
}

void BrushTool::move(const ToolMouse& mouse) {
    lookAt(surfaceUnder(mouse));
    if (!m_down) return;
    const double spacing =
        strokeSpacing * m_painting.sharesAt(mouse.pressure).radius * m_painting.brush().radius;
    std::vector<std::optional<BrushTouch>> touches;
    m_down->way.goTo(mouse.place);
    for (const auto& [point, share] : brushPointsAlong(mouse.sight, m_down->way, spacing)) {
        const auto pressure = pressureBetween(m_down->pressure, mouse.pressure, share);
        touches.push_back(point ? std::optional(BrushTouch{*point, pressure}) : std::nullopt);
    }
    goOn(touches);
    if (m_down) m_down->pressure = mouse.pressure;
}

/// One that came down beside the organ begins where it reaches the surface.
void BrushTool::goOn(const std::vector<std::optional<BrushTouch>>& touches) {
    auto next = touches.begin();
    if (!m_down->hasBegun) {
        next = std::find_if(next, touches.end(), [](const auto& touch) { return touch.has_value(); });
        if (next == touches.end()) return;
        m_down->hasBegun = true;
        m_painting.begin(**next++);
    }
    m_painting.goOn({next, touches.end()});
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
    if (copies(brush.kind) && m_painting.source())
        if (const auto place = sight.placeOf(*m_painting.source())) paintSource(painter, *place);
    if (!m_at) return;
    const auto circle = [&](double radius) {
        return sight.placesOf(circleAround(m_at->point, m_at->spot.outward, radius));
    };
    const double radius = m_painting.sharesAt(m_down ? m_down->pressure : std::nullopt).radius * brush.radius;
    paintBrush(painter, circle(radius), circle((1 - brush.softness) * radius));
}

} // namespace esm
