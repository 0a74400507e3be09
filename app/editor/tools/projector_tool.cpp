#include "app/editor/tools/projector_tool.h"

#include "widgets/view/overlay.h"

#include <QAction>

namespace esm {

namespace {

constexpr double photoHandleReach = 9; // pixels around a handle's middle

/// The handle of the selected photo under the mouse.
std::optional<std::size_t> photoHandleAt(const ToolMouse& mouse) {
    const DrawnProjector* selected = selectedOf(mouse.sight.scene.projectors);
    if (!selected) return std::nullopt;
    const auto places = handles(faceOf(*selected));
    for (std::size_t i = 0; i < places.size(); ++i) {
        const auto seen = mouse.sight.placeOf(places[i]);
        if (seen && distance(*seen, mouse.place) <= photoHandleReach) return i;
    }
    return std::nullopt;
}

} // namespace

ProjectorTool::ProjectorTool(const ToolContext& context)
    : m_document(context.document), m_selection(context.selection), m_showProjector(context.showProjector) {
    connect(&m_document, &Document::changed, this, [this](const Change& change) {
        if (m_drag && (change.isOfHistory || !findPart(m_document.project().layers, m_drag->photo)))
            release();
    });
    // Another project counts its photos anew.
    connect(&m_document, &Document::replaced, this, &ProjectorTool::release);
}

Hold ProjectorTool::press(const ToolMouse& mouse) {
    const auto photo = m_selection.photo();
    if (!photo) return Hold::Nothing;
    const auto& projectors = mouse.sight.scene.projectors; // that of the selected photo
    if (const auto handle = photoHandleAt(mouse)) {
        m_drag = Drag{*photo, faceOf(*selectedOf(projectors)), *handle};
        return Hold::Drag;
    }
    const Ray ray = mouse.ray();
    const int under = projectorUnder(mouse.sight.scene, ray);
    if (under < 0) return Hold::Nothing;
    const PhotoFace face = faceOf(projectors[static_cast<std::size_t>(under)]);
    const Eigen::Vector3d grabbed = ray.origin + *distanceTo(face, ray) * ray.direction.normalized();
    m_drag = Drag{*photo, face, DragPlane{grabbed, face.projector.pose.linear().col(2)}};
    return Hold::Drag;
}

/// A corner is drawn freely with it.
bool ProjectorTool::takesShift(const ToolMouse& mouse) const {
    return photoHandleAt(mouse).has_value();
}

std::vector<QPointF> ProjectorTool::stops(const Sight& sight) const {
    const DrawnProjector* selected = selectedOf(sight.scene.projectors);
    if (!selected) return {};
    const auto points = handles(faceOf(*selected));
    const QPolygonF places = sight.placesOf({points.begin(), points.end()});
    return {places.begin(), places.end()};
}

void ProjectorTool::move(const ToolMouse& mouse) {
    if (!m_drag) return;
    const bool isFree = mouse.keys.testFlag(Qt::ShiftModifier);
    const bool isControl = mouse.keys.testFlag(Qt::ControlModifier);
    const LayerId photo = m_drag->photo;
    Projector dragged = m_drag->start.projector;
    if (const auto* handle = std::get_if<std::size_t>(&m_drag->held))
        dragged = scaled(
            m_drag->start, *handle, mouse.ray(),
            {isFree ? Proportions::Free : Proportions::Kept, isControl ? Stays::Middle : Stays::OtherSide});
    else
        dragged.pose.pretranslate(shift(std::get<DragPlane>(m_drag->held), mouse.ray()));
    place(photo, dragged);
}

void ProjectorTool::place(LayerId photo, const Projector& projector) {
    m_document.edit(tr("Place photo"),
                    [&](Project& project) { partOf(project.layers, photo).projector = projector; },
                    {EditKind::ProjectorDrag, photo});
}

void ProjectorTool::cancel() {
    if (m_drag) place(m_drag->photo, m_drag->start.projector);
    release();
}

void ProjectorTool::release() {
    if (m_drag) m_document.finishGesture();
    m_drag.reset();
}

void ProjectorTool::draw(QPainter& painter, const Sight& sight, const QPalette& palette) const {
    const DrawnProjector* selected = selectedOf(sight.scene.projectors);
    if (!selected) return;
    std::vector<PaintedHandle> painted;
    for (const Eigen::Vector3d& handle : handles(faceOf(*selected)))
        if (const auto place = sight.placeOf(handle)) painted.push_back({*place});
    paintHandles(painter, painted, palette.color(QPalette::LinkVisited));
}

QString ProjectorTool::hint() const {
    return m_showProjector.isChecked() ? QString()
                                       : tr("The projector's box is hidden: {showProjector} shows it");
}

} // namespace esm
