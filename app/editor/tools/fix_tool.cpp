#include "app/editor/tools/fix_tool.h"

#include "app/editor/tools/fix_panel.h"
#include "core/authoring/fixed_nodes.h"
#include "widgets/view/brush_outline.h"

#include <algorithm>

namespace esm {

namespace {

/// Share of the radius from one point of a stroke to the next.
constexpr double fixSpacing = 0.5;

double meanRestLength(const std::vector<Spring>& springs) {
    double sum = 0;
    for (const Spring& spring : springs)
        sum += spring.restLength;
    return springs.empty() ? 0 : sum / static_cast<double>(springs.size());
}

/// Where nodes lie far apart, a brush that is small beside the organ would pass between them and fix none.
double usualRadius(const Project& project) {
    constexpr double shareOfOrgan = 0.03;
    return std::max(shareOfOrgan * organBox(*project.mesh, *project.network).diagonal().norm(),
                    meanRestLength(project.network->springs));
}

} // namespace

FixTool::FixTool(const ToolContext& context) : m_document(context.document) {
    connect(&m_document, &Document::changed, this, &FixTool::followDocument);
    followDocument(Change::everything());
}

void FixTool::followDocument(const Change& change) {
    if (change.isOfHistory) release();
    if (!change.mesh) return;
    m_stroke.reset();
    m_at.reset();
    setRadius(usualRadius(m_document.project()));
}

void FixTool::setRadius(double metres) {
    m_radius = std::min(metres, largestRadius());
    emit changed();
}

double FixTool::largestRadius() const {
    const Project& project = m_document.project();
    return organBox(*project.mesh, *project.network).diagonal().norm() / 2;
}

QWidget* FixTool::makeOptions() {
    return new FixPanel(*this, m_document);
}

Hold FixTool::press(const ToolMouse& mouse) {
    lookAt(mouse);
    if (!m_at && !isNearSurface(mouse.sight, mouse.place)) return Hold::Nothing;
    const bool frees = mouse.keys.testFlag(Qt::ControlModifier);
    m_stroke =
        Stroke{frees ? Does::Free : Does::Fix, m_document.project().scene.fixed, MouseWay(mouse.place)};
    move(mouse);
    return Hold::Stroke;
}

void FixTool::move(const ToolMouse& mouse) {
    lookAt(mouse);
    if (!m_stroke) return;
    m_stroke->way.goTo(mouse.place);
    const std::vector<std::uint32_t> nodes = nodesTo(mouse);
    const Does does = m_stroke->does;
    edit([&](Project& project) { does == Does::Fix ? fixNodes(project, nodes) : freeNodes(project, nodes); });
}

/// From where the mouse was last.
std::vector<std::uint32_t> FixTool::nodesTo(const ToolMouse& mouse) const {
    const Project& project = m_document.project();
    if (project.mesh->triangles.empty()) return m_at ? std::vector{m_at->node} : std::vector<std::uint32_t>();
    std::vector<std::uint32_t> nodes;
    std::vector<Eigen::Vector3d> path;
    const auto take = [&] {
        for (const std::uint32_t node : nodesAlong(*project.network, path, m_radius))
            nodes.push_back(node);
        path.clear();
    };
    if (const auto from = brushPointAt(mouse.sight, m_stroke->way.at(0))) path.push_back(from->place);
    for (const auto& [point, share] : brushPointsAlong(mouse.sight, m_stroke->way, fixSpacing * m_radius)) {
        if (point)
            path.push_back(point->place);
        else
            take();
    }
    take();
    return nodes;
}

void FixTool::edit(const std::function<void(Project&)>& change) {
    m_document.edit(m_stroke->does == Does::Fix ? tr("Fix nodes") : tr("Free nodes"), change,
                    MergeKey(EditKind::FixedNodes));
}

void FixTool::release() {
    if (!m_stroke) return;
    m_stroke.reset();
    m_document.finishGesture();
}

void FixTool::cancel() {
    if (m_stroke) edit([&](Project& project) { project.scene.fixed = m_stroke->before; });
    release();
    leave();
}

void FixTool::leave() {
    m_at.reset();
    emit changed();
}

void FixTool::lookAt(const ToolMouse& mouse) {
    m_at = mouse.picked();
    emit changed();
}

void FixTool::draw(QPainter& painter, const Sight& sight, const QPalette&) const {
    if (!m_at || m_at->normal.isZero()) return;
    const QPolygonF rim = sight.placesOf(circleAround(m_at->point, m_at->spot.outward, m_radius));
    paintBrush(painter, rim, rim);
}

} // namespace esm
