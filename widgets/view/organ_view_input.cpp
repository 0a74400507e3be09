#include "widgets/view/axis_cube.h"
#include "widgets/view/organ_view.h"

#include <algorithm>
#include <cmath>

namespace esm {
namespace {

using Eigen::Vector3d;

constexpr double handleReach = 9;     // pixels around a handle's middle
constexpr double clickReach = 4;      // pixels a click may wander before it is a drag
constexpr double nodeReach = 12;      // pixels around a node that is picked without a surface
constexpr double turnReach = 26;      // pixels from an axis' end to its turning handle
constexpr double pushPerNotch = 0.15; // of the instrument's radius

double distance(const QPointF& a, const QPointF& b) {
    return std::hypot(a.x() - b.x(), a.y() - b.y());
}

template<typename Drawn> int selectedIndex(const std::vector<Drawn>& shapes) {
    const auto found =
        std::find_if(shapes.begin(), shapes.end(), [](const Drawn& drawn) { return drawn.selected; });
    return found == shapes.end() ? -1 : static_cast<int>(found - shapes.begin());
}

} // namespace

void OrganView::mousePressEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton && !m_cameraController.isDragging()) {
        const auto face = viewAt(event->localPos(), camera(), cubeSquare(size()));
        if (face) return showView(*face);
    }
    if (m_drag || (!drawsCornerFreely(*event) && m_cameraController.press(*event))) return;
    if (event->button() != Qt::LeftButton) return;
    if (m_tool == ViewTool::Brush && event->modifiers().testFlag(Qt::ControlModifier)) {
        if (const auto source = brushPointAt(event->localPos())) emit brushSourcePicked(*source);
        return;
    }
    m_pressed = event->localPos();
    m_drag = dragAt(event->localPos());
    if (m_drag && std::holds_alternative<BrushMove>(*m_drag)) {
        m_pressed.reset(); // a click is a stroke, too
        if (const auto point = brushPointAt(event->localPos())) emit brushStarted(*point);
        return;
    }
    if (const auto* pull = m_drag ? std::get_if<PullDrag>(&*m_drag) : nullptr) emit pullStarted(pull->node);
    if (!m_drag) m_cameraController.startOrbit(*event);
}

void OrganView::mouseMoveEvent(QMouseEvent* event) {
    if (m_pressed && distance(*m_pressed, event->localPos()) > clickReach) m_pressed.reset();
    if (m_drag) {
        const bool isFree = event->modifiers().testFlag(Qt::ShiftModifier);
        if (!m_pressed) followDrag(event->localPos(), isFree ? Proportions::Free : Proportions::Kept);
    } else if (m_cameraController.isDragging()) {
        if (m_pressed) return;
        m_cameraController.move(*event, size());
        applyCamera(camera());
    } else if (m_tool == ViewTool::Instrument) {
        moveInstrument(event->localPos());
    } else if (m_tool == ViewTool::Brush) {
        brushPointAt(event->localPos());
    } else if (m_tool == ViewTool::Region) {
        setCursor(regionHandleAt(event->localPos()) ? Qt::PointingHandCursor : Qt::ArrowCursor);
    }
}

void OrganView::mouseReleaseEvent(QMouseEvent* event) {
    const bool wasClick = m_pressed && event->button() == Qt::LeftButton;
    m_pressed.reset();
    if (event->button() == Qt::LeftButton) endDrag();
    m_cameraController.release(*event);
    if (wasClick) click(*event);
}

void OrganView::wheelEvent(QWheelEvent* event) {
    if (m_tool == ViewTool::Instrument && event->modifiers().testFlag(Qt::ControlModifier))
        return pushInstrument(wheelNotches(*event), event->position());
    m_cameraController.zoom(*event, size());
    applyCamera(camera());
}

void OrganView::keyPressEvent(QKeyEvent* event) {
    if (event->key() != Qt::Key_Escape) return QOpenGLWidget::keyPressEvent(event);
    letGo();
}

void OrganView::leaveEvent(QEvent* event) {
    if (!m_drag) removeInstrument();
    m_brushAt.reset();
    update();
    QOpenGLWidget::leaveEvent(event);
}

std::optional<Drag> OrganView::dragAt(const QPointF& place) {
    const Ray ray = rayAt(place);
    switch (m_tool) {
    case ViewTool::Select:
    case ViewTool::Place:
        return std::nullopt;
    case ViewTool::Landmark: {
        const std::optional<int> mark = markAt(paintedMarks(), place);
        return mark ? std::optional<Drag>(LandmarkMove{*mark}) : std::nullopt;
    }
    case ViewTool::Region:
        return regionDragAt(place, ray);
    case ViewTool::Projector:
        return projectorDragAt(place, ray);
    case ViewTool::Instrument:
        if (!m_instrument) moveInstrument(place);
        if (!m_instrument) return std::nullopt;
        return InstrumentSweep{picturePlane(camera(), *m_instrument)};
    case ViewTool::Brush:
        return brushPointAt(place) ? std::optional<Drag>(BrushMove{}) : std::nullopt;
    case ViewTool::Pull:
        break;
    }
    const std::optional<PickedPoint> picked = pickAt(place);
    if (!picked) return std::nullopt;
    return PullDrag{picked->node, picturePlane(camera(), picked->point),
                    picked->nodePosition - picked->point};
}

std::optional<RegionHandle> OrganView::regionHandleAt(const QPointF& place) const {
    std::optional<RegionHandle> nearest;
    double least = handleReach;
    for (const RegionHandle& handle : shownRegionHandles()) {
        const auto seen = placeOf(handle.place);
        if (!seen || distance(*seen, place) > least) continue;
        least = distance(*seen, place);
        nearest = handle;
    }
    return nearest;
}

std::optional<Drag> OrganView::regionDragAt(const QPointF& place, const Ray& ray) const {
    if (const auto handle = regionHandleAt(place)) {
        const int selected = selectedIndex(m_scene.ellipsoids);
        const Ellipsoid& shape = m_scene.ellipsoids[static_cast<std::size_t>(selected)].shape;
        switch (handle->kind) {
        case RegionHandle::Kind::Size:
            return RegionScale{selected, shape, handle->end};
        case RegionHandle::Kind::Turn:
            return RegionTurn{selected, shape, {handle->place, ray}};
        case RegionHandle::Kind::Rim:
            return RimSize{selected, shape, picturePlane(camera(), handle->place)};
        }
    }
    const int under = ellipsoidUnder(m_scene, ray);
    if (under < 0) return std::nullopt;
    const Ellipsoid& shape = m_scene.ellipsoids[static_cast<std::size_t>(under)].shape;
    const Vector3d grabbed = ray.origin + *distanceTo(shape, ray) * ray.direction.normalized();
    return RegionMove{under, shape, picturePlane(camera(), grabbed)};
}

std::optional<Drag> OrganView::cornerDragAt(const QPointF& place) const {
    const int selected = selectedIndex(m_scene.projectors);
    if (m_tool != ViewTool::Projector || selected < 0) return std::nullopt;
    const PhotoFace photo = faceOf(m_scene.projectors[static_cast<std::size_t>(selected)]);
    const auto places = handles(photo);
    for (std::size_t i = 0; i < places.size(); ++i) {
        const auto seen = placeOf(places[i]);
        if (seen && distance(*seen, place) <= handleReach) return ProjectorScale{selected, photo, i};
    }
    return std::nullopt;
}

/// Elsewhere, Shift and a drag shift the view.
bool OrganView::drawsCornerFreely(const QMouseEvent& event) const {
    return !m_cameraController.isDragging() && event.button() == Qt::LeftButton &&
           event.modifiers() == Qt::ShiftModifier && cornerDragAt(event.localPos());
}

std::optional<Drag> OrganView::projectorDragAt(const QPointF& place, const Ray& ray) const {
    if (auto corner = cornerDragAt(place)) return corner;
    const int under = projectorUnder(m_scene, ray);
    if (under < 0) return std::nullopt;
    const PhotoFace photo = faceOf(m_scene.projectors[static_cast<std::size_t>(under)]);
    const Vector3d grabbed = ray.origin + *distanceTo(photo, ray) * ray.direction.normalized();
    return ProjectorMove{under, photo.projector, {grabbed, photo.projector.pose.linear().col(2)}};
}

void OrganView::followDrag(const QPointF& place, Proportions proportions) {
    const Ray ray = rayAt(place);
    const Drag drag = *m_drag; // a slot may end the drag while it is told of it
    if (const auto* pull = std::get_if<PullDrag>(&drag)) {
        if (const auto aim = target(*pull, ray)) emit pullMoved(pull->node, *aim);
    } else if (const auto* move = std::get_if<RegionMove>(&drag)) {
        emit regionDragged(move->index, dragged(*move, ray));
    } else if (const auto* scale = std::get_if<RegionScale>(&drag)) {
        emit regionDragged(scale->index, dragged(*scale, ray));
    } else if (const auto* turn = std::get_if<RegionTurn>(&drag)) {
        emit regionDragged(turn->index, dragged(*turn, ray));
    } else if (const auto* rim = std::get_if<RimSize>(&drag)) {
        if (const auto width = dragged(*rim, ray)) emit rimDragged(rim->index, *width);
    } else if (const auto* shift = std::get_if<ProjectorMove>(&drag)) {
        emit projectorDragged(shift->index, dragged(*shift, ray));
    } else if (const auto* size = std::get_if<ProjectorScale>(&drag)) {
        emit projectorDragged(size->index, dragged(*size, ray, proportions));
    } else if (const auto* landmark = std::get_if<LandmarkMove>(&drag)) {
        if (const auto picked = pickAt(place)) emit markDragged(landmark->number, picked->spot.point);
    } else if (std::holds_alternative<BrushMove>(drag)) {
        if (const auto point = brushPointAt(place)) emit brushMoved(*point);
    } else if (const auto* sweep = std::get_if<InstrumentSweep>(&drag)) {
        m_instrument = meet(ray, sweep->plane);
        showInstrument();
        if (m_instrument) emit instrumentMoved(*m_instrument);
    }
}

void OrganView::endDrag() {
    if (!m_drag) return;
    const Drag ended = *m_drag;
    m_drag.reset();
    if (std::holds_alternative<LandmarkMove>(ended)) return emit markDropped();
    if (std::holds_alternative<BrushMove>(ended)) return emit brushLifted();
    if (std::holds_alternative<PullDrag>(ended))
        emit pullReleased();
    else if (!std::holds_alternative<InstrumentSweep>(ended))
        emit dragFinished();
}

void OrganView::click(const QMouseEvent& event) {
    const QPointF place = event.localPos();
    if (m_tool == ViewTool::Place) return clickSpot(place, event.modifiers().testFlag(Qt::ControlModifier));
    if (m_tool == ViewTool::Landmark) return clickLandmark(place);
    const Ray ray = rayAt(place);
    const int region = m_tool == ViewTool::Projector ? -1 : ellipsoidUnder(m_scene, ray);
    const int projector = m_tool == ViewTool::Region ? -1 : projectorUnder(m_scene, ray);
    const bool picks =
        m_tool == ViewTool::Select || m_tool == ViewTool::Region || m_tool == ViewTool::Projector;
    if (!picks) return;
    if (region >= 0) return emit regionPicked(region);
    if (projector >= 0) return;
    if (const auto picked = pickAt(place)) emit pointPicked(picked->node, picked->point);
}

void OrganView::clickSpot(const QPointF& place, bool anew) {
    if (const auto picked = pickAt(place)) emit spotPicked(picked->spot, anew);
}

void OrganView::clickLandmark(const QPointF& place) {
    if (const auto mark = markAt(paintedMarks(), place)) return emit markSelected(*mark);
    if (const auto picked = pickAt(place)) emit landmarkPicked(picked->spot.point);
}

std::optional<BrushPoint> OrganView::brushPointAt(const QPointF& place) {
    m_brushAt = m_scene.mesh && !m_scene.mesh->triangles.empty() ? pickAt(place) : std::nullopt;
    update();
    if (!m_brushAt || m_brushAt->normal.isZero()) return std::nullopt;
    return BrushPoint{m_brushAt->spot.point, m_brushAt->normal};
}

void OrganView::dropStroke() {
    if (!m_drag || !std::holds_alternative<BrushMove>(*m_drag)) return;
    m_drag.reset();
    emit brushDropped();
}

std::optional<PickedPoint> OrganView::pickAt(const QPointF& place) {
    return m_picker.pick(m_scene, rayAt(place), nodeReach / height() * camera().verticalFieldOfView);
}

void OrganView::moveInstrument(const QPointF& place) {
    const Ray ray = rayAt(place);
    if (m_instrumentPushed && m_instrument) {
        m_instrument = meet(ray, picturePlane(camera(), *m_instrument));
    } else if (const auto hit = m_picker.pick(m_scene, ray, 0)) {
        m_instrument = hit->point - m_instrumentRadius * ray.direction.normalized();
    } else {
        const Vector3d depth = m_instrument.value_or(camera().target);
        m_instrument = meet(ray, picturePlane(camera(), depth));
    }
    showInstrument();
    if (m_instrument) emit instrumentMoved(*m_instrument);
}

void OrganView::pushInstrument(double notches, const QPointF& place) {
    if (!m_instrument) moveInstrument(place);
    if (!m_instrument) return;
    m_instrumentPushed = true;
    *m_instrument += notches * pushPerNotch * m_instrumentRadius * rayAt(place).direction;
    showInstrument();
    emit instrumentMoved(*m_instrument);
}

void OrganView::removeInstrument() {
    m_instrumentPushed = false;
    if (!m_instrument) return;
    m_instrument.reset();
    showInstrument();
    emit instrumentRemoved();
}

void OrganView::showInstrument() {
    m_scene.instrument.reset();
    if (m_instrument) m_scene.instrument = DrawnSphere{*m_instrument, m_instrumentRadius};
    update();
}

double OrganView::pixelAt(const Vector3d& point) const {
    const double depth = (camera().eye - point).dot(cameraAxes(camera()).col(2));
    return 2 * std::tan(camera().verticalFieldOfView / 2) * depth / std::max(1, height());
}

std::vector<RegionHandle> OrganView::shownRegionHandles() const {
    const int selected = selectedIndex(m_scene.ellipsoids);
    if (selected < 0) return {};
    const DrawnEllipsoid& region = m_scene.ellipsoids[static_cast<std::size_t>(selected)];
    return regionHandles(region, camera(), turnReach * pixelAt(region.shape.centre));
}

std::vector<PaintedHandle> OrganView::paintedRegionHandles() const {
    using Form = PaintedHandle::Form;
    std::vector<PaintedHandle> painted;
    for (const RegionHandle& handle : shownRegionHandles()) {
        const Form form = handle.kind == RegionHandle::Kind::Size   ? Form::Square
                          : handle.kind == RegionHandle::Kind::Turn ? Form::Round
                                                                    : Form::Diamond;
        const auto place = placeOf(handle.place), root = placeOf(handle.root);
        if (place) painted.push_back({*place, form, form == Form::Round ? root : std::nullopt});
    }
    return painted;
}

std::vector<PaintedHandle> OrganView::projectorHandles() const {
    std::vector<PaintedHandle> painted;
    const int selected = selectedIndex(m_scene.projectors);
    if (selected < 0) return painted;
    for (const Vector3d& handle : handles(faceOf(m_scene.projectors[static_cast<std::size_t>(selected)])))
        if (const auto place = placeOf(handle)) painted.push_back({*place});
    return painted;
}

std::vector<PaintedMark> OrganView::paintedMarks() {
    constexpr double hidingShare = 1e-3; // of the way to the eye, by which surface must lie nearer
    std::vector<PaintedMark> painted;
    for (const OrganMark& mark : m_marks) {
        const auto place = placeOf(mark.point);
        if (!place) continue;
        const double distance = (mark.point - camera().eye).norm();
        const auto first = m_picker.pick(m_scene, {camera().eye, mark.point - camera().eye}, 0);
        const bool isHidden = first && (first->point - camera().eye).norm() < (1 - hidingShare) * distance;
        painted.push_back({*place, mark.look, isHidden});
    }
    return painted;
}

} // namespace esm
