#include "widgets/view/organ_view.h"

#include "core/render/drawn_shape.h"
#include "widgets/view/axis_cube.h"

#include <QOpenGLContext>
#include <QPainter>
#include <QSurfaceFormat>

#include <algorithm>
#include <exception>

namespace esm {
namespace {

void* resolved(const char* name) {
    return reinterpret_cast<void*>(QOpenGLContext::currentContext()->getProcAddress(name));
}

} // namespace

QSurfaceFormat viewFormat() {
    QSurfaceFormat format;
    format.setVersion(3, 3);
    format.setProfile(QSurfaceFormat::CoreProfile);
    format.setDepthBufferSize(24);
    format.setSamples(4);
    return format;
}

OrganView::OrganView(QWidget* parent) : QOpenGLWidget(parent) {
    setFormat(viewFormat());
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setMinimumSize(240, 180);
}

OrganView::~OrganView() {
    dropRenderer();
}

void OrganView::setScene(RenderScene scene) {
    m_scene = std::move(scene);
    m_picker.sceneChanged();
    if (m_instrument) showInstrument();
    if (!m_framed && !organBox().isEmpty()) frameOrgan();
    update();
}

void OrganView::setNodePositions(std::vector<Eigen::Vector3d> positions) {
    m_scene.nodePositions = std::move(positions);
    m_picker.sceneChanged();
    update();
}

void OrganView::setLegend(std::optional<ViewLegend> legend) {
    m_legend = std::move(legend);
    update();
}

void OrganView::setMarks(std::vector<OrganMark> marks) {
    m_marks = std::move(marks);
    update();
}

void OrganView::setHint(const QString& hint) {
    m_hint = hint;
    update();
}

void OrganView::setTool(ViewTool tool) {
    if (tool == m_tool) return;
    letGo();
    m_tool = tool;
    m_brushAt.reset();
    const bool points = tool == ViewTool::Place || tool == ViewTool::Landmark || tool == ViewTool::Brush;
    setCursor(points ? Qt::CrossCursor : Qt::ArrowCursor);
    update();
    emit toolChanged(tool);
    if (tool == ViewTool::Instrument && underMouse()) moveInstrument(mapFromGlobal(QCursor::pos()));
}

void OrganView::setInstrumentRadius(double metres) {
    m_instrumentRadius = metres;
    if (!m_instrument) return;
    showInstrument();
    emit instrumentMoved(*m_instrument);
}

void OrganView::setBrush(const ViewBrush& brush) {
    m_brush = brush;
    update();
}

void OrganView::letGo() {
    dropStroke();
    endDrag();
    removeInstrument();
}

void OrganView::setCamera(const Camera& camera) {
    m_framed = true;
    applyCamera(camera);
}

void OrganView::showView(StandardView view) {
    setCamera(framedCamera(organBox(), view, aspect()));
}

void OrganView::frameOrgan() {
    setCamera(reframed(camera(), organBox(), aspect()));
}

void OrganView::applyCamera(const Camera& camera) {
    m_cameraController.setCamera(camera);
    update();
    emit cameraChanged();
}

double OrganView::aspect() const {
    return static_cast<double>(std::max(1, width())) / std::max(1, height());
}

Ray OrganView::rayAt(const QPointF& place) const {
    return pickRay(camera(), place.x() / std::max(1, width()), place.y() / std::max(1, height()), aspect());
}

std::optional<QPointF> OrganView::placeOf(const Eigen::Vector3d& point) const {
    const std::optional<Eigen::Vector2d> place = picturePoint(camera(), point, aspect());
    if (!place) return std::nullopt;
    return QPointF(place->x() * width(), place->y() * height());
}

Eigen::AlignedBox3d OrganView::organBox() const {
    const std::vector<Eigen::Vector3d> nodes = drawnNodes(m_scene);
    const Eigen::AlignedBox3d surface = boundingBox(drawnVertices(m_scene, nodes));
    const bool showsNodes = m_scene.showSprings || surface.isEmpty();
    return showsNodes ? surface.merged(boundingBox(nodes)) : surface;
}

void OrganView::initializeGL() {
    connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, &OrganView::dropRenderer,
            Qt::UniqueConnection);
    try {
        m_renderer = std::make_unique<Renderer>(resolved);
        m_problem.clear();
    } catch (const std::exception& problem) {
        m_problem = cannotBeShown(problem);
    }
}

void OrganView::dropRenderer() {
    if (!m_renderer) return;
    makeCurrent();
    m_renderer.reset();
    doneCurrent();
}

void OrganView::paintGL() {
    if (m_renderer) drawScene();
    paintOverlay();
    emit drawn();
}

void OrganView::drawScene() {
    const double ratio = devicePixelRatioF();
    try {
        m_renderer->draw(m_scene, camera(), {qRound(width() * ratio), qRound(height() * ratio), ratio});
        m_problem.clear();
    } catch (const std::exception& problem) {
        m_problem = cannotBeShown(problem);
    }
}

QString OrganView::cannotBeShown(const std::exception& problem) {
    return tr("The organ cannot be shown: %1").arg(QString::fromUtf8(problem.what()));
}

void OrganView::paintOverlay() {
    QPainter painter(this);
    if (!m_problem.isEmpty()) {
        painter.fillRect(rect(), palette().color(QPalette::Window));
        painter.setPen(palette().color(QPalette::WindowText));
        painter.drawText(rect().adjusted(20, 20, -20, -20), Qt::AlignCenter | Qt::TextWordWrap, m_problem);
        return;
    }
    painter.setRenderHint(QPainter::Antialiasing);
    const OverlayStyle style{size(), palette()};
    if (m_tool == ViewTool::Region)
        paintHandles(painter, paintedRegionHandles(), style.palette.color(QPalette::Highlight));
    if (m_tool == ViewTool::Projector)
        paintHandles(painter, projectorHandles(), style.palette.color(QPalette::LinkVisited));
    if (m_tool == ViewTool::Landmark) paintMarks(painter, paintedMarks(), style.palette);
    if (m_tool == ViewTool::Brush) paintBrushTool(painter);
    if (m_legend) paintLegend(painter, style, *m_legend);
    paintHint(painter, style, hint(), m_legend.has_value());
    paintAxisCube(painter, camera(), cubeSquare(size()), style.palette);
}

void OrganView::paintBrushTool(QPainter& painter) {
    if (m_brush.source)
        if (const auto place = placeOf(*m_brush.source)) paintSource(painter, *place);
    if (!m_brushAt) return;
    const auto circle = [this](double radius) {
        return seen(circleAround(m_brushAt->point, m_brushAt->spot.outward, radius));
    };
    paintBrush(painter, circle(m_brush.radius), circle((1 - m_brush.softness) * m_brush.radius));
}

/// Without what lies behind the eye.
QPolygonF OrganView::seen(const std::vector<Eigen::Vector3d>& points) const {
    QPolygonF polygon;
    for (const Eigen::Vector3d& point : points)
        if (const auto place = placeOf(point)) polygon << *place;
    return polygon;
}

} // namespace esm
