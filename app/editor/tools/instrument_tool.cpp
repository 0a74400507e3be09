#include "app/editor/tools/instrument_tool.h"

#include "app/editor/tools/instrument_options.h"
#include "core/render/camera.h"
#include "core/support/angles.h"
#include "widgets/inputs/number_text.h"
#include "widgets/view/dragging.h"
#include "widgets/view/overlay.h"

#include <algorithm>
#include <cmath>

namespace esm {

namespace {

constexpr double pushPerNotch = 0.15;                          // of the instrument's radius
constexpr double tiltPerNotch = 5 * pi / 180;                  // radians
constexpr double usualTilt = 50 * pi / 180, mostTilt = pi / 2; // radians

/// To half a millimetre where that is fine enough, m.
double rounded(double metres) {
    constexpr double half = 0.0005; // m
    return metres > 10 * half ? half * std::round(metres / half) : metres;
}

/// A ball of a twentieth of the organ's diagonal, or a shaft a quarter as thick that reaches out of it.
Collider fittingInstrument(const Project& project, InstrumentKind kind) {
    const double diagonal = organBox(*project.mesh, *project.network).diagonal().norm();
    if (kind == InstrumentKind::Ball) return Sphere{rounded(0.05 * diagonal)};
    return Capsule{rounded(0.0125 * diagonal), rounded(diagonal)};
}

InstrumentKind kindOf(const Collider& shape) {
    return std::holds_alternative<Sphere>(shape) ? InstrumentKind::Ball : InstrumentKind::Shaft;
}

/// As a right hand holds it: towards the eye, and to the lower right by `tilt`.
Eigen::Vector3d handDirection(const Camera& camera, double tilt) {
    const Eigen::Matrix3d axes = cameraAxes(camera);
    return (std::cos(tilt) * axes.col(2) + std::sin(tilt) * (axes.col(0) - axes.col(1)).normalized())
        .normalized();
}

} // namespace

InstrumentTool::InstrumentTool(const ToolContext& context)
    : m_document(context.document), m_preview(context.preview), m_tilt(usualTilt) {
    connect(&m_document, &Document::changed, this, &InstrumentTool::followDocument);
    connect(&m_preview, &Preview::statusChanged, this, &InstrumentTool::changed);
    connect(&m_preview, &Preview::frameReady, this, [this] {
        if (m_tip) emit changed();
    });
    followDocument(Change::everything());
}

void InstrumentTool::followDocument(const Change& change) {
    if (!change.mesh) return;
    // Where the hand is on one organ says nothing about the next.
    cancel();
    if (!m_isChosen) setShape(fittingInstrument(m_document.project(), kindOf(m_shape)));
}

void InstrumentTool::chooseKind(InstrumentKind kind) {
    if (kind == kindOf(m_shape)) return;
    Collider shape = fittingInstrument(m_document.project(), kind);
    if (m_isChosen) std::visit([this](auto& fitting) { fitting.radius = radiusOf(m_shape); }, shape);
    setShape(shape);
}

void InstrumentTool::chooseRadius(double metres) {
    m_isChosen = true;
    Collider shape = m_shape;
    std::visit([metres](auto& chosen) { chosen.radius = metres; }, shape);
    setShape(shape);
}

void InstrumentTool::chooseLength(double metres) {
    m_isChosen = true;
    setShape(Capsule{radiusOf(m_shape), metres});
}

void InstrumentTool::setShape(const Collider& shape) {
    m_shape = shape;
    if (m_tip) show();
    emit shapeChanged();
}

Hold InstrumentTool::press(const ToolMouse& mouse) {
    if (!m_tip) hover(mouse);
    if (!m_tip) return Hold::Nothing;
    m_sweep = picturePlane(mouse.sight.camera, *m_tip);
    return Hold::Drag;
}

void InstrumentTool::move(const ToolMouse& mouse) {
    if (!m_sweep) return hover(mouse);
    lead(mouse, meet(mouse.ray(), *m_sweep));
}

void InstrumentTool::lead(const ToolMouse& mouse, const std::optional<Eigen::Vector3d>& tip) {
    m_tip = tip;
    m_towardsHand = handDirection(mouse.sight.camera, m_tilt);
    show();
}

void InstrumentTool::hover(const ToolMouse& mouse) {
    const Ray ray = mouse.ray();
    if (m_isPushed && m_tip) return lead(mouse, meet(ray, picturePlane(mouse.sight.camera, *m_tip)));
    if (const auto hit = mouse.sight.picker.pick(mouse.sight.scene, ray))
        return lead(mouse, hit->point - radiusOf(m_shape) * ray.direction.normalized());
    const Eigen::Vector3d depth = m_tip.value_or(mouse.sight.camera.target);
    lead(mouse, meet(ray, picturePlane(mouse.sight.camera, depth)));
}

bool InstrumentTool::wheel(const ToolMouse& mouse, double notches) {
    if (!mouse.keys.testFlag(Qt::ControlModifier)) return false;
    if (!m_tip) hover(mouse);
    if (!m_tip) return true;
    if (mouse.keys.testFlag(Qt::ShiftModifier)) {
        m_tilt = std::clamp(m_tilt - notches * tiltPerNotch, 0.0, mostTilt);
        lead(mouse, m_tip);
        return true;
    }
    m_isPushed = true;
    lead(mouse, *m_tip + notches * pushPerNotch * radiusOf(m_shape) * mouse.ray().direction);
    return true;
}

void InstrumentTool::cancel() {
    m_sweep.reset();
    m_isPushed = false;
    if (!m_tip) return;
    m_tip.reset();
    m_preview.setInstrument(std::nullopt);
    emit changed();
}

void InstrumentTool::leave() {
    if (!m_sweep) cancel();
}

void InstrumentTool::show() {
    emit changed();
    if (!m_tip) return;
    m_preview.setGentleMotion(false);
    m_preview.setInstrument(placed());
}

/// Precondition: it has a tip.
PlacedCollider InstrumentTool::placed() const {
    return {m_shape,
            {*m_tip + lengthOf(m_shape) / 2 * m_towardsHand,
             Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), m_towardsHand)}};
}

/// Where the tissue meets it, which may be behind the mouse.
PlacedCollider InstrumentTool::shown() const {
    const std::optional<PlacedCollider> met = m_preview.heldInstrument();
    return met && met->shape == m_shape ? *met : placed();
}

void InstrumentTool::dress(RenderScene& scene) const {
    scene.heldInstrument.reset();
    if (m_tip) scene.heldInstrument = shown();
}

/// What is felt beside the tip, above a ball.
void InstrumentTool::draw(QPainter& painter, const Sight& sight, const QPalette& palette) const {
    const std::optional<FeltTissue> felt = m_tip ? m_preview.status().instrument : std::nullopt;
    if (!felt) return;
    const ColliderAxis axis = axisOf(shown());
    const Eigen::Vector3d above = axis.at(-axis.half) + radiusOf(m_shape) * cameraAxes(sight.camera).col(1);
    if (const auto place = sight.placeOf(above)) paintLabel(painter, *place, feltText(*felt), palette);
}

QWidget* InstrumentTool::makeOptions() {
    return new InstrumentOptions(*this);
}

} // namespace esm
