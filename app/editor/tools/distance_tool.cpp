#include "app/editor/tools/distance_tool.h"

#include "app/editor/tools/distance_panel.h"
#include "core/support/errors.h"
#include "widgets/inputs/number_text.h"
#include "widgets/view/overlay.h"

#include <cmath>

namespace esm {

namespace {

constexpr double pointReach = 10;   // pixels around a point that is taken hold of
constexpr double pointRadius = 4.5; // pixels
constexpr double sameLength = 1e-9; // share by which two lengths are one

/// To scale the whole project at every step of a drag would hold the drag up.
constexpr int restBeforeFinding = 300; // ms

/// Points lie on the same corners of another shape of the same organ.
bool isSameTopology(const TriangleMesh& a, const TriangleMesh& b) {
    return a.vertices.size() == b.vertices.size() && a.triangles == b.triangles;
}

/// Seen on dark and on light tissue alike.
void paintLine(QPainter& painter, const QLineF& line, const QColor& colour) {
    painter.setPen(QPen(QColor(0, 0, 0, 150), 3.6));
    painter.drawLine(line);
    painter.setPen(QPen(colour, 1.8));
    painter.drawLine(line);
}

void paintPoint(QPainter& painter, const QPointF& place, const QColor& colour) {
    painter.setPen(QPen(QColor(0, 0, 0, 150), 1.2));
    painter.setBrush(Qt::white);
    painter.drawEllipse(place, pointRadius + 1, pointRadius + 1);
    painter.setPen(Qt::NoPen);
    painter.setBrush(colour);
    painter.drawEllipse(place, pointRadius - 1.5, pointRadius - 1.5);
}

} // namespace

DistanceTool::DistanceTool(const ToolContext& context) : m_document(context.document) {
    connect(&m_document, &Document::changed, this, &DistanceTool::followDocument);
    m_rest.setSingleShot(true);
    m_rest.setInterval(restBeforeFinding);
    connect(&m_rest, &QTimer::timeout, this, &DistanceTool::update);
    followDocument(Change::everything());
}

/// What can be scaled depends on nearly all of a project: with the density kept, on the tissue's masses too.
/// Only another organ changes what is measured.
void DistanceTool::followDocument(const Change& change) {
    if (!change.mesh) {
        if (m_trueLength && length()) m_rest.start();
        return;
    }
    const Project& project = m_document.project();
    const bool isOther =
        m_surface && (!isSameTopology(*m_surface, *project.mesh) ||
                      m_network->restPositions.size() != project.network->restPositions.size());
    if (isOther) m_points.clear();
    m_held.reset();
    m_begun.reset();
    m_surface = project.mesh;
    m_network = project.network;
    update();
}

Eigen::Vector3d DistanceTool::restPoint(const CarriedPlace& place) const {
    return pointOf(place, m_surface->triangles.empty() ? m_network->restPositions : m_surface->vertices);
}

std::optional<double> DistanceTool::length() const {
    if (m_points.size() < 2) return std::nullopt;
    return (restPoint(m_points[1]) - restPoint(m_points[0])).norm();
}

void DistanceTool::setTrueLength(double metres) {
    m_trueLength = metres;
    update();
}

void DistanceTool::setKept(KeptByScaling kept) {
    m_kept = kept;
    update();
}

void DistanceTool::update() {
    m_rest.stop();
    m_obstacle = findObstacle();
    emit changed();
}

/// What scaling finds wrong is found by scaling: no rule stands here that could come apart from the core's.
/// While points are dragged the answer would be old at once.
QString DistanceTool::findObstacle() const {
    if (!length() || m_held) return tr("Pick two points on the organ first");
    if (!(*length() > 0)) return tr("The two points are one: move one of them");
    if (!m_trueLength) return tr("Type the true length between the points first");
    if (std::abs(*m_trueLength / *length() - 1) < sameLength)
        return tr("The distance has this length already");
    try {
        scaled(m_document.project(),
               scaleFactor(restPoint(m_points[0]), restPoint(m_points[1]), *m_trueLength), m_kept);
    } catch (const InvalidModel& problem) {
        return QString::fromUtf8(problem.what());
    }
    return {};
}

void DistanceTool::scaleOrgan() {
    if (isObstacleOld()) update();
    if (!m_obstacle.isEmpty()) return;
    const double factor = scaleFactor(restPoint(m_points[0]), restPoint(m_points[1]), *m_trueLength);
    m_document.edit(tr("Scale organ"), [&](Project& project) { project = scaled(project, factor, m_kept); });
}

std::optional<std::size_t> DistanceTool::pointAt(const ToolMouse& mouse) const {
    std::optional<std::size_t> nearest;
    double least = pointReach;
    for (std::size_t i = 0; i < m_points.size(); ++i) {
        const auto seen = mouse.sight.placeOf(mouse.sight.picker.carried(mouse.sight.scene, m_points[i]));
        if (!seen || distance(*seen, mouse.place) > least) continue;
        least = distance(*seen, mouse.place);
        nearest = i;
    }
    return nearest;
}

Hold DistanceTool::press(const ToolMouse& mouse) {
    m_held = pointAt(mouse);
    if (m_held) return Hold::Drag;
    if (const auto picked = mouse.picked()) m_begun = picked->carried;
    return m_begun ? Hold::Drag : Hold::Nothing;
}

void DistanceTool::move(const ToolMouse& mouse) {
    if (!m_held && !m_begun) {
        m_isOverPoint = pointAt(mouse).has_value();
        return;
    }
    const auto picked = mouse.picked();
    if (!picked) return;
    if (m_begun) m_points = {*std::exchange(m_begun, std::nullopt), picked->carried};
    if (!m_held) m_held = 1;
    m_points[*m_held] = picked->carried;
    update();
}

void DistanceTool::release() {
    m_held.reset();
    m_begun.reset();
    update();
}

void DistanceTool::click(const ToolMouse& mouse) {
    const auto picked = mouse.picked();
    if (pointAt(mouse) || !picked) return;
    if (m_points.size() != 1) m_points.clear();
    m_points.push_back(picked->carried);
    update();
}

void DistanceTool::cancel() {
    m_points.clear();
    m_isOverPoint = false;
    release();
}

void DistanceTool::draw(QPainter& painter, const Sight& sight, const QPalette& palette) const {
    const QColor& accent = palette.color(QPalette::Highlight);
    std::vector<QPointF> places;
    for (const CarriedPlace& point : m_points)
        if (const auto place = sight.placeOf(sight.picker.carried(sight.scene, point)))
            places.push_back(*place);
    painter.save();
    const QLineF line = places.size() == 2 ? QLineF(places[0], places[1]) : QLineF();
    if (!line.isNull()) paintLine(painter, line, Qt::white);
    for (const QPointF& place : places)
        paintPoint(painter, place, accent);
    if (places.size() == 2)
        paintLabel(painter, line.center(), withUnit(1000 * *length(), QStringLiteral("mm")), palette);
    painter.restore();
}

Qt::CursorShape DistanceTool::cursor() const {
    return m_isOverPoint ? Qt::PointingHandCursor : Qt::CrossCursor;
}

QString DistanceTool::hint() const {
    if (m_points.size() == 1) return tr("Now click the second point · Esc drops the first");
    if (m_points.size() == 2)
        return tr("Drag a point to move it · at the right its true length scales the organ · Esc drops both");
    return {};
}

QWidget* DistanceTool::makeOptions() {
    return new DistancePanel(*this);
}

} // namespace esm
