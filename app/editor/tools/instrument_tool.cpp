#include "app/editor/tools/instrument_tool.h"

#include "app/editor/tools/instrument_options.h"
#include "widgets/view/dragging.h"

#include <cmath>

namespace esm {

namespace {

constexpr double pushPerNotch = 0.15; // of the instrument's radius

/// A twentieth of the organ's diagonal, to half a millimetre where that is fine enough.
double fittingInstrument(const Project& project) {
    constexpr double half = 0.0005; // m
    const double twentieth = 0.05 * organBox(*project.mesh, *project.network).diagonal().norm();
    return twentieth > 10 * half ? half * std::round(twentieth / half) : twentieth;
}

} // namespace

InstrumentTool::InstrumentTool(const ToolContext& context)
    : m_document(context.document), m_preview(context.preview) {
    connect(&m_document, &Document::changed, this, &InstrumentTool::followDocument);
    connect(&m_preview, &Preview::statusChanged, this, &InstrumentTool::changed);
    followDocument(Change::everything());
}

void InstrumentTool::followDocument(const Change& change) {
    if (!change.mesh) return;
    // Where the hand is on one organ says nothing about the next.
    cancel();
    if (!m_isChosen) setRadius(fittingInstrument(m_document.project()));
}

void InstrumentTool::chooseRadius(double metres) {
    m_isChosen = true;
    setRadius(metres);
}

void InstrumentTool::setRadius(double metres) {
    m_radius = metres;
    if (m_centre) show();
    emit radiusChanged(metres);
}

Hold InstrumentTool::press(const ToolMouse& mouse) {
    if (!m_centre) hover(mouse);
    if (!m_centre) return Hold::Nothing;
    m_sweep = picturePlane(mouse.sight.camera, *m_centre);
    return Hold::Drag;
}

void InstrumentTool::move(const ToolMouse& mouse) {
    if (!m_sweep) return hover(mouse);
    m_centre = meet(mouse.ray(), *m_sweep);
    show();
}

void InstrumentTool::hover(const ToolMouse& mouse) {
    const Ray ray = mouse.ray();
    if (m_isPushed && m_centre) {
        m_centre = meet(ray, picturePlane(mouse.sight.camera, *m_centre));
    } else if (const auto hit = mouse.sight.picker.pick(mouse.sight.scene, ray, 0)) {
        m_centre = hit->point - m_radius * ray.direction.normalized();
    } else {
        const Eigen::Vector3d depth = m_centre.value_or(mouse.sight.camera.target);
        m_centre = meet(ray, picturePlane(mouse.sight.camera, depth));
    }
    show();
}

bool InstrumentTool::wheel(const ToolMouse& mouse, double notches) {
    if (!mouse.keys.testFlag(Qt::ControlModifier)) return false;
    if (!m_centre) hover(mouse);
    if (!m_centre) return true;
    m_isPushed = true;
    *m_centre += notches * pushPerNotch * m_radius * mouse.ray().direction;
    show();
    return true;
}

void InstrumentTool::cancel() {
    m_sweep.reset();
    m_isPushed = false;
    if (!m_centre) return;
    m_centre.reset();
    m_preview.setInstrument(std::nullopt);
    emit changed();
}

void InstrumentTool::leave() {
    if (!m_sweep) cancel();
}

void InstrumentTool::show() {
    emit changed();
    if (!m_centre) return;
    m_preview.setGentleMotion(false);
    m_preview.setInstrument(sphereAt(*m_centre, m_radius));
}

void InstrumentTool::dress(RenderScene& scene) const {
    scene.instrument.reset();
    if (m_centre) scene.instrument = DrawnSphere{*m_centre, m_radius};
}

QWidget* InstrumentTool::makeOptions() {
    return new InstrumentOptions(*this);
}

} // namespace esm
