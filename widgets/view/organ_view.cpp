#include "widgets/view/organ_view.h"

#include "core/render/drawn_shape.h"
#include "widgets/view/axis_cube.h"

#include <QOpenGLContext>
#include <QPainter>
#include <QSurfaceFormat>

#include <algorithm>
#include <exception>
#include <utility>

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
    m_tool->dress(m_scene);
    if (!m_framed && !organBox().isEmpty()) frameOrgan();
    update();
}

void OrganView::changeScene(const std::function<void(RenderScene&)>& change) {
    change(m_scene);
    m_tool->dress(m_scene);
    update();
}

void OrganView::setNodePositions(std::vector<Eigen::Vector3d> positions) {
    m_scene.nodePositions = std::move(positions);
    m_picker.sceneChanged();
    update();
}

void OrganView::setInstruments(std::vector<PlacedCollider> instruments) {
    m_scene.instruments = std::move(instruments);
    update();
}

void OrganView::setLegend(std::optional<ViewLegend> legend) {
    m_legend = std::move(legend);
    update();
}

void OrganView::setHint(const QString& hint) {
    m_hint = hint;
    update();
}

void OrganView::setTool(ViewTool& tool) {
    if (&tool == m_tool) return;
    cancel();
    disconnect(m_tool, nullptr, this, nullptr);
    m_tool = &tool;
    connect(m_tool, &ViewTool::changed, this, &OrganView::followTool);
    followTool();
    emit toolChanged();
    if (!underMouse()) return;
    const QPointF place = mapFromGlobal(QCursor::pos());
    moveTool({sight(), place, Qt::NoModifier});
}

void OrganView::followTool() {
    m_tool->dress(m_scene);
    setCursor(m_tool->cursor());
    update();
}

void OrganView::letGo() {
    if (std::exchange(m_hold, Hold::Nothing) != Hold::Nothing) m_tool->release();
}

void OrganView::cancel() {
    m_hold = Hold::Nothing;
    m_tool->cancel();
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

Sight OrganView::sight() {
    return {m_scene, camera(), size(), m_picker};
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

/// GL objects can only be deleted in their context, which goes before this widget does.
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
    m_tool->draw(painter, sight(), style.palette);
    if (m_legend) paintLegend(painter, style, *m_legend);
    paintHint(painter, style, m_hint, m_legend.has_value());
    paintAxisCube(painter, camera(), cubeSquare(size()), style.palette);
}

} // namespace esm
