#include "app/editor/tools/projector_tool.h"

#include "core/support/angles.h"
#include "widgets/inputs/number_text.h"
#include "widgets/view/overlay.h"

#include <QAction>

#include <cmath>
#include <utility>

namespace esm {

namespace {

using GripKind = ProjectorHandle::Kind;

constexpr double photoHandleReach = 9;     // pixels around a handle's middle
constexpr double besidePhoto = 26;         // pixels from the photo to the handles that turn it
constexpr double photoPushPerNotch = 0.02; // of the way to what the projector looks at

std::vector<ProjectorHandle> shownPhotoHandles(const Sight& sight) {
    const DrawnProjector* selected = selectedOf(sight.scene.projectors);
    if (!selected) return {};
    const PhotoFace face = faceOf(*selected);
    return projectorHandles(face, sight.camera, besidePhoto * sight.pixelAt(handles(face)[6]));
}

/// What the middle of a photo is projected on; beside the organ the place before it.
Eigen::Vector3d lookedAt(const PhotoFace& face, const Sight& sight) {
    const Ray line = photoSight(face);
    if (const auto met = sight.picker.pick(sight.scene, line)) return met->point;
    const Eigen::AlignedBox3d box = boundingBox(sight.scene.mesh->vertices);
    const double way = (box.center() - line.origin).dot(line.direction);
    return line.origin + (way > 0 ? way : box.diagonal().norm() / 2) * line.direction;
}

/// Of a line on the screen, degrees, 0 to 180 from the right upwards.
double slantOnScreen(const QPointF& line) {
    const double degrees = toDegrees(std::atan2(-line.y(), line.x()));
    return degrees < 0 ? degrees + 180 : degrees;
}

/// The arrows that lie as the line does.
Qt::CursorShape arrowCursor(double slant) {
    constexpr Qt::CursorShape shapes[] = {Qt::SizeHorCursor, Qt::SizeBDiagCursor, Qt::SizeVerCursor,
                                          Qt::SizeFDiagCursor};
    return shapes[static_cast<int>(std::lround(slant / 45)) % 4];
}

PaintedHandle::Form photoHandleForm(GripKind kind) {
    using Form = PaintedHandle::Form;
    switch (kind) {
    case GripKind::Size:
        return Form::Square;
    case GripKind::Roll:
        return Form::Round;
    case GripKind::Turn:
        return Form::Ring;
    case GripKind::Push:
        return Form::Diamond;
    }
    return Form::Square;
}

QString photoHandleUse(const ProjectorHandle& handle) {
    switch (handle.kind) {
    case GripKind::Size:
        return ProjectorTool::tr("Drag to scale the photo, the opposite side stays · with Ctrl its middle · "
                                 "with Shift width and height apart");
    case GripKind::Roll:
        return ProjectorTool::tr("Drag to roll the photo about its line of sight · with Shift in steps of "
                                 "15°");
    case GripKind::Turn:
        return ProjectorTool::tr("Drag to turn the projector about what it looks at · with Ctrl about its "
                                 "own place · with Shift in steps of 15°");
    case GripKind::Push:
        return ProjectorTool::tr("Drag to push the projector along its line of sight");
    }
    return {};
}

/// How far a drag has come.
QString photoDragText(GripKind kind, const Projector& start, const Projector& now) {
    if (kind == GripKind::Push) {
        const double metres = (now.pose.translation() - start.pose.translation()).norm();
        return ProjectorTool::tr("Pushed by %1 mm").arg(decimalText(1000 * metres, 1));
    }
    const QString degrees = decimalText(turnBetween(start, now), 1);
    return kind == GripKind::Roll ? ProjectorTool::tr("Rolled by %1°").arg(degrees)
                                  : ProjectorTool::tr("Turned by %1°").arg(degrees);
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

/// The nearest handle, else the photo.
std::optional<ProjectorTool::Held> ProjectorTool::heldAt(const ToolMouse& mouse) const {
    const DrawnProjector* selected = selectedOf(mouse.sight.scene.projectors);
    if (!selected) return std::nullopt;
    std::optional<Held> held;
    double least = photoHandleReach;
    for (const ProjectorHandle& handle : shownPhotoHandles(mouse.sight)) {
        const auto seen = mouse.sight.placeOf(handle.at);
        if (!seen || distance(*seen, mouse.place) > least) continue;
        least = distance(*seen, mouse.place);
        const PhotoFace face = faceOf(*selected);
        const auto middle = mouse.sight.placeOf((handles(face)[4] + handles(face)[6]) / 2);
        held = Held{handle, middle ? slantOnScreen(*seen - *middle) : 0};
    }
    const bool isOverPhoto = distanceTo(faceOf(*selected), mouse.ray()).has_value();
    return held || !isOverPhoto ? held : Held{};
}

Hold ProjectorTool::press(const ToolMouse& mouse) {
    const auto photo = m_selection.photo();
    const auto held = photo ? heldAt(mouse) : std::nullopt;
    if (!held) return Hold::Nothing;
    const PhotoFace face = faceOf(*selectedOf(mouse.sight.scene.projectors));
    const Ray ray = mouse.ray();
    const Eigen::Vector3d grabbed =
        ray.origin + distanceTo(face, ray).value_or(0) * ray.direction.normalized();
    endPushing();
    m_drag = Drag{
        *photo,      face, *held, lookedAt(face, mouse.sight), {grabbed, face.projector.pose.linear().col(2)},
        mouse.place, ray};
    return Hold::Drag;
}

bool ProjectorTool::takesShift(const ToolMouse& mouse) const {
    const auto held = heldAt(mouse);
    return held && held->handle;
}

std::vector<QPointF> ProjectorTool::stops(const Sight& sight) const {
    std::vector<Eigen::Vector3d> points;
    for (const ProjectorHandle& handle : shownPhotoHandles(sight))
        points.push_back(handle.at);
    const QPolygonF places = sight.placesOf(points);
    return {places.begin(), places.end()};
}

void ProjectorTool::move(const ToolMouse& mouse) {
    if (!m_drag) {
        endPushing();
        return lookAt(heldAt(mouse));
    }
    const LayerId photo = m_drag->photo;
    const Projector now = dragged(*m_drag, mouse);
    place(photo, now);
    emit changed();
}

Projector ProjectorTool::dragged(const Drag& drag, const ToolMouse& mouse) const {
    const bool isShift = mouse.keys.testFlag(Qt::ShiftModifier);
    if (!drag.held.handle) {
        Projector moved = drag.start.projector;
        moved.pose.pretranslate(shift(drag.plane, mouse.ray()));
        return moved;
    }
    switch (drag.held.handle->kind) {
    case GripKind::Size:
        return scaled(drag.start, drag.held.handle->place, mouse.ray(),
                      {isShift ? Proportions::Free : Proportions::Kept,
                       mouse.keys.testFlag(Qt::ControlModifier) ? Stays::Middle : Stays::OtherSide});
    case GripKind::Roll:
        return rolled(drag.start, drag.ray, mouse.ray(), isShift);
    case GripKind::Turn:
        return turnedBy(drag, mouse);
    case GripKind::Push:
        return pushed(drag.start, drag.target, drag.ray, mouse.ray());
    }
    return drag.start.projector;
}

/// What follows the mouse lies elsewhere than the handle: it goes as far on the screen.
Projector ProjectorTool::turnedBy(const Drag& drag, const ToolMouse& mouse) const {
    const ProjectorTurn turn{drag.start, drag.target, mouse.keys.testFlag(Qt::ControlModifier),
                             mouse.keys.testFlag(Qt::ShiftModifier)};
    const QPointF grip = mouse.sight.placeOf(turnedPlace(turn)).value_or(drag.place);
    return turned(turn, mouse.sight.rayAt(grip), mouse.sight.rayAt(grip + mouse.place - drag.place));
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
    if (!m_drag) return;
    m_document.finishGesture();
    m_drag.reset();
    emit changed();
}

void ProjectorTool::leave() {
    lookAt(std::nullopt);
}

bool ProjectorTool::wheel(const ToolMouse& mouse, double notches) {
    const DrawnProjector* selected = selectedOf(mouse.sight.scene.projectors);
    const auto photo = m_selection.photo();
    if (!mouse.keys.testFlag(Qt::ControlModifier) || m_drag || !selected || !photo) return false;
    const PhotoFace face = faceOf(*selected);
    m_isPushing = true;
    place(*photo, pushedBy(face, lookedAt(face, mouse.sight), photoPushPerNotch * notches));
    return true;
}

/// Notches of the wheel are one step until the mouse moves again.
void ProjectorTool::endPushing() {
    if (std::exchange(m_isPushing, false)) m_document.finishGesture();
}

void ProjectorTool::lookAt(const std::optional<Held>& held) {
    const auto kindOf = [](const std::optional<Held>& what) {
        return what && what->handle ? std::pair(int(what->handle->kind), what->handle->place)
                                    : std::pair(what ? -1 : -2, std::size_t{0});
    };
    const bool isSame = kindOf(held) == kindOf(m_under);
    m_under = held;
    if (!isSame) emit changed();
}

void ProjectorTool::draw(QPainter& painter, const Sight& sight, const QPalette& palette) const {
    const std::optional<Held>& held = m_drag ? m_drag->held : m_under;
    std::vector<PaintedHandle> painted;
    for (const ProjectorHandle& handle : shownPhotoHandles(sight)) {
        const auto place = sight.placeOf(handle.at), root = sight.placeOf(handle.root);
        if (!place) continue;
        const bool isLit =
            held && held->handle && held->handle->kind == handle.kind && held->handle->place == handle.place;
        const bool isBeside = handle.kind != GripKind::Size;
        painted.push_back({*place, photoHandleForm(handle.kind), isBeside ? root : std::nullopt, isLit});
    }
    paintHandles(painter, painted, palette.color(QPalette::LinkVisited));
}

Qt::CursorShape ProjectorTool::cursor() const {
    const std::optional<Held>& held = m_drag ? m_drag->held : m_under;
    if (!held) return Qt::ArrowCursor;
    if (!held->handle) return Qt::SizeAllCursor;
    const GripKind kind = held->handle->kind;
    const bool isAlong = kind == GripKind::Size || kind == GripKind::Push;
    return isAlong ? arrowCursor(held->slant) : Qt::PointingHandCursor;
}

QString ProjectorTool::hint() const {
    if (!m_showProjector.isChecked()) return tr("The projector's box is hidden: {showProjector} shows it");
    if (m_drag && m_drag->held.handle && m_drag->held.handle->kind != GripKind::Size)
        if (const TextureLayer* layer = findPart(m_document.project().layers, m_drag->photo))
            return photoDragText(m_drag->held.handle->kind, m_drag->start.projector, layer->projector);
    return !m_drag && m_under && m_under->handle ? photoHandleUse(*m_under->handle) : QString();
}

} // namespace esm
