#include "app/editor/tools/region_tool.h"

#include "app/editor/tools/region_picking.h"
#include "widgets/view/overlay.h"

#include <QAction>

#include <algorithm>
#include <utility>

namespace esm {

namespace {

constexpr double handleReach = 9; // pixels around a handle's middle
constexpr double turnReach = 26;  // pixels from an axis' end to its turning handle

/// Those of the selected region that are not cut away.
std::vector<RegionHandle> shownHandles(const Sight& sight) {
    const DrawnEllipsoid* region = selectedOf(sight.scene.ellipsoids);
    if (!region) return {};
    std::vector<RegionHandle> shown =
        regionHandles(*region, sight.camera, turnReach * sight.pixelAt(region->shape.centre));
    if (const auto& cut = sight.scene.cut)
        std::erase_if(shown, [&](const RegionHandle& handle) { return cut->hides(handle.place); });
    return shown;
}

std::optional<RegionHandle> handleAt(const ToolMouse& mouse) {
    std::optional<RegionHandle> nearest;
    double least = handleReach;
    for (const RegionHandle& handle : shownHandles(mouse.sight)) {
        const auto seen = mouse.sight.placeOf(handle.place);
        if (!seen || distance(*seen, mouse.place) > least) continue;
        least = distance(*seen, mouse.place);
        nearest = handle;
    }
    return nearest;
}

/// Of the organ at rest, where it is seen.
std::optional<Eigen::Vector3d> surfaceAt(const Sight& sight, const QPointF& place) {
    const auto& mesh = sight.scene.mesh;
    const auto picked = mesh && !mesh->triangles.empty() ? sight.pickAt(place) : std::nullopt;
    return picked ? std::optional(picked->spot.point) : std::nullopt;
}

PaintedHandle::Form formOf(RegionHandle::Kind kind) {
    using Kind = RegionHandle::Kind;
    if (kind == Kind::Size) return PaintedHandle::Form::Square;
    return kind == Kind::Turn ? PaintedHandle::Form::Round : PaintedHandle::Form::Diamond;
}

} // namespace

RegionTool::RegionTool(const ToolContext& context)
    : m_document(context.document), m_selection(context.selection), m_showRegions(context.showRegions) {
    connect(&m_document, &Document::changed, this, &RegionTool::followDocument);
    // Another project counts its regions anew.
    connect(&m_document, &Document::replaced, this, &RegionTool::release);
}

/// None for one that hangs wholly before the organ: to follow the surface, it would have to stay there.
std::optional<RegionTool::OnSurface> RegionTool::onSurface(const ToolMouse& mouse, const Ellipsoid& shape) {
    const auto middle = mouse.sight.placeOf(shape.centre);
    const auto surface = middle ? surfaceAt(mouse.sight, *middle) : std::nullopt;
    if (!surface) return std::nullopt;
    const Eigen::Vector3d ahead = mouse.sight.rayAt(*middle).direction.normalized();
    const double depth = (shape.centre - *surface).dot(ahead);
    if (depth < 0 && distanceOutside(shape, *surface) > 0) return std::nullopt;
    return OnSurface{*middle - mouse.place, depth};
}

/// What is gone cannot be dragged on, nor what was undone.
void RegionTool::followDocument(const Change& change) {
    if (change.isOfHistory) release();
    if (!m_drag) return;
    const Region* region = findPart(m_document.project().regions, m_drag->region);
    if (!region || !region->ellipsoid) release();
}

Hold RegionTool::press(const ToolMouse& mouse) {
    m_drag = dragAt(mouse);
    return m_drag ? Hold::Drag : Hold::Nothing;
}

std::optional<RegionTool::Drag> RegionTool::dragAt(const ToolMouse& mouse) const {
    const auto& [scene, camera, size, picker] = mouse.sight;
    const Ray ray = mouse.ray();
    if (const auto handle = handleAt(mouse)) {
        const DrawnEllipsoid* selected = selectedOf(scene.ellipsoids);
        const auto region = drawnRegion(m_document, static_cast<int>(selected - scene.ellipsoids.data()));
        if (!region) return std::nullopt;
        switch (handle->kind) {
        case RegionHandle::Kind::Size:
            return Drag{*region, selected->shape, Size{handle->end}};
        case RegionHandle::Kind::Turn:
            return Drag{*region, selected->shape, Turn{{handle->place, ray}}};
        case RegionHandle::Kind::Rim:
            return Drag{
                *region, selected->shape,
                Rim{picturePlane(camera, handle->place), partOf(m_document.project().regions, *region).rim}};
        }
    }
    const int under = ellipsoidUnder(scene, ray);
    const auto region = drawnRegion(m_document, under);
    if (!region) return std::nullopt;
    const Ellipsoid& shape = scene.ellipsoids[static_cast<std::size_t>(under)].shape;
    const Eigen::Vector3d grabbed = ray.origin + *distanceTo(shape, ray) * ray.direction.normalized();
    return Drag{*region, shape, Move{picturePlane(camera, grabbed), onSurface(mouse, shape)}};
}

void RegionTool::move(const ToolMouse& mouse) {
    if (!m_drag) {
        m_isOverHandle = handleAt(mouse).has_value();
        return;
    }
    const Drag drag = *m_drag; // who hears of the edit may end the drag
    m_selection.setRegion(drag.region);
    follow(drag, mouse);
}

/// Beside the organ it stays where it left the surface.
Ellipsoid RegionTool::moved(const Drag& drag, const ToolMouse& mouse) const {
    const Move& move = std::get<Move>(drag.what);
    Ellipsoid moved = drag.start;
    if (!move.onSurface || mouse.keys.testFlag(Qt::ControlModifier)) {
        moved.centre += shift(move.plane, mouse.ray());
        return moved;
    }
    const QPointF middle = mouse.place + move.onSurface->fromMouse;
    const auto surface = surfaceAt(mouse.sight, middle);
    if (!surface) return *partOf(m_document.project().regions, drag.region).ellipsoid;
    moved.centre = *surface + move.onSurface->depth * mouse.sight.rayAt(middle).direction.normalized();
    return moved;
}

void RegionTool::follow(const Drag& drag, const ToolMouse& mouse) {
    const Ray ray = mouse.ray();
    if (const auto* rim = std::get_if<Rim>(&drag.what)) {
        // None inside.
        if (const auto point = meet(ray, rim->plane))
            widenRim(drag.region, distanceOutside(drag.start, *point));
    } else if (const auto* size = std::get_if<Size>(&drag.what)) {
        shape(drag.region, scaled(drag.start, size->end, ray));
    } else if (const auto* turn = std::get_if<Turn>(&drag.what)) {
        shape(drag.region, turned(drag.start, turn->grip, ray));
    } else {
        shape(drag.region, moved(drag, mouse));
    }
}

void RegionTool::shape(RegionId region, const Ellipsoid& shape) {
    m_document.edit(tr("Shape region"),
                    [&](Project& project) { partOf(project.regions, region).ellipsoid = shape; },
                    {EditKind::RegionShape, region});
}

void RegionTool::widenRim(RegionId region, double metres) {
    m_document.edit(tr("Soft rim"), [&](Project& project) { partOf(project.regions, region).rim = metres; },
                    {EditKind::SoftRim, region});
}

void RegionTool::release() {
    if (m_drag) m_document.finishGesture();
    m_drag.reset();
}

void RegionTool::cancel() {
    if (const auto drag = std::exchange(m_drag, std::nullopt)) {
        if (const auto* rim = std::get_if<Rim>(&drag->what))
            widenRim(drag->region, rim->start);
        else
            shape(drag->region, drag->start);
        m_document.finishGesture();
    }
}

void RegionTool::click(const ToolMouse& mouse) {
    selectRegionUnder(mouse, m_document, m_selection);
}

void RegionTool::draw(QPainter& painter, const Sight& sight, const QPalette& palette) const {
    std::vector<PaintedHandle> painted;
    for (const RegionHandle& handle : shownHandles(sight)) {
        const PaintedHandle::Form form = formOf(handle.kind);
        const auto place = sight.placeOf(handle.place), root = sight.placeOf(handle.root);
        if (place)
            painted.push_back({*place, form, form == PaintedHandle::Form::Round ? root : std::nullopt});
    }
    paintHandles(painter, painted, palette.color(QPalette::Highlight));
}

/// The region's middle, by which it is moved, then its handles.
std::vector<QPointF> RegionTool::stops(const Sight& sight) const {
    std::vector<Eigen::Vector3d> points;
    if (const DrawnEllipsoid* region = selectedOf(sight.scene.ellipsoids))
        points.push_back(region->shape.centre);
    for (const RegionHandle& handle : shownHandles(sight))
        points.push_back(handle.place);
    const QPolygonF places = sight.placesOf(points);
    return {places.begin(), places.end()};
}

Qt::CursorShape RegionTool::cursor() const {
    return m_isOverHandle ? Qt::PointingHandCursor : Qt::ArrowCursor;
}

QString RegionTool::whyNot() const {
    const auto& regions = m_document.project().regions;
    const bool hasEllipsoid = std::any_of(regions.begin(), regions.end(),
                                          [](const Region& region) { return region.ellipsoid.has_value(); });
    if (!hasEllipsoid) return tr("There is no region yet: {addRegion} adds one");
    return m_showRegions.isChecked() ? QString() : tr("The regions are hidden: {showRegions} shows them");
}

} // namespace esm
