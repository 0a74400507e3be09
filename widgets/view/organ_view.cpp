#include "widgets/view/organ_view.h"

#include "core/render/drawn_shape.h"
#include "widgets/view/approach.h"
#include "widgets/view/axis_cube.h"
#include "widgets/view/view_words.h"
#include "widgets/view/within.h"

#include <QPainter>

#include <algorithm>
#include <cmath>
#include <utility>

namespace esm {

OrganView::OrganView(QWidget* parent, PictureDrawing drawing) : QWidget(parent), m_maker(std::move(drawing)) {
    setFocusPolicy(Qt::WheelFocus);
    setMouseTracking(true);
    setMinimumSize(240, 110);
    setAttribute(Qt::WA_OpaquePaintEvent);
    setAccessibleName(tr("Organ"));
    m_keyPointer.setStops([this] { return m_tool->stops(sight()); });
    connect(&m_maker, &PictureMaker::made, this, &OrganView::takePicture);
}

void OrganView::setScene(RenderScene scene) {
    m_scene = std::move(scene);
    m_picker.sceneChanged();
    m_tool->dress(m_scene);
    if (!m_framed && !organBox().isEmpty()) frameOrgan();
    redraw();
}

void OrganView::changeScene(const std::function<void(RenderScene&)>& change) {
    change(m_scene);
    m_tool->dress(m_scene);
    redraw();
}

void OrganView::setNodePositions(std::vector<Eigen::Vector3d> positions) {
    m_scene.nodePositions = std::move(positions);
    m_picker.sceneChanged();
    redraw();
}

void OrganView::setInstruments(std::vector<PlacedCollider> instruments) {
    m_scene.instruments = std::move(instruments);
    redraw();
}

void OrganView::setInstrumentNames(QStringList names) {
    m_instrumentNames = std::move(names);
    update();
}

void OrganView::setLegend(std::optional<ViewLegend> legend) {
    m_legend = std::move(legend);
    update();
}

void OrganView::setHint(const QString& hint) {
    if (hint == m_hint) return;
    m_hint = hint;
    tellSpoken(*this);
    update();
}

QString OrganView::spokenValue() const {
    QStringList said{sideWords(camera())};
    if (m_legend) said << legendWords(*m_legend);
    if (!m_hint.isEmpty()) said << m_hint;
    return said.join(QStringLiteral(". "));
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
    redraw();
}

void OrganView::letGo() {
    if (std::exchange(m_hold, Hold::Nothing) != Hold::Nothing) m_tool->release();
}

void OrganView::cancel() {
    m_hold = Hold::Nothing;
    m_pressed.reset();
    m_tool->cancel();
    m_keyPointer.hide();
}

void OrganView::setCamera(const Camera& camera) {
    putCamera(camera, std::nullopt);
}

void OrganView::putCamera(const Camera& camera, const std::optional<Camera>& outside) {
    m_framed = true;
    m_outside = outside;
    m_former.reset();
    m_through.reset();
    m_cameraController.setLookingAround(isWithin());
    applyCamera(camera);
}

/// With the lens from before it looked from within, or through another one.
Camera OrganView::outsideCamera() const {
    const std::optional<Camera>& before = m_outside ? m_outside : m_former;
    Camera result = before.value_or(camera());
    result.eye = camera().eye;
    result.target = camera().target;
    result.up = camera().up;
    return result;
}

void OrganView::showView(StandardView view) {
    const Camera framed = framedCamera(organBox(), view, aspect());
    setCamera(isOrthographic() ? reframed(orthographic(framed), organBox(), aspect()) : framed);
    m_whole = camera();
}

void OrganView::frameOrgan() {
    setCamera(reframed(outsideCamera(), organBox(), aspect()));
    m_whole = camera();
}

void OrganView::frame(const Eigen::AlignedBox3d& box) {
    const Camera framed = reframed(outsideCamera(), box, aspect());
    setCamera(outOfSurface({m_scene, framed, size(), m_picker}));
}

void OrganView::setOrthographic(bool on) {
    if (on == isOrthographic()) return;
    const Camera outside = m_outside ? *m_outside : m_former.value_or(camera());
    setCamera(on ? orthographic(outside) : perspective(outside));
}

bool OrganView::lookFromWithin(const std::optional<Eigen::Vector3d>& about) {
    std::optional<Camera> within = cameraWithin(sight(), about);
    if (!within && underMouse())
        if (const auto picked = sight().pickAt(mapFromGlobal(QCursor::pos())))
            within = cameraWithin(sight(), picked->point);
    if (within) putCamera(*within, m_outside.value_or(camera()));
    return within.has_value();
}

void OrganView::leaveWithin() {
    if (m_outside) setCamera(Camera(*m_outside));
}

void OrganView::lookThrough(const Camera& seeing) {
    const Camera former = m_outside ? *m_outside : m_former.value_or(camera());
    putCamera(seeing, std::nullopt);
    m_former = former;
    m_through = camera();
    emit cameraChanged();
}

void OrganView::leaveThrough() {
    if (m_former) setCamera(Camera(*m_former));
}

bool OrganView::isThrough() const {
    return m_through && *m_through == camera();
}

void OrganView::applyCamera(const Camera& camera) {
    const bool isFlat = camera.orthographicHeight.has_value();
    m_cameraController.setCamera(isFlat ? standingBefore(camera, organBox()) : camera);
    redraw();
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

/// Asked for once the widget is painted, so that changes which come together are drawn together, and what is
/// hidden not at all.
void OrganView::redraw() {
    m_isStale = true;
    update();
}

void OrganView::askForPicture() {
    const double ratio = m_askedRatio = devicePixelRatioF();
    m_asked = m_maker.ask({m_scene, camera(), {qRound(width() * ratio), qRound(height() * ratio), ratio}});
    m_isStale = false;
}

void OrganView::takePicture() {
    const int former = m_picture.number;
    m_picture = m_maker.picture();
    update();
    if (m_picture.number != former && m_picture.problem.isEmpty()) emit drawn();
}

bool OrganView::isUpToDate() const {
    return !m_isStale && m_picture.number == m_asked && m_picture.isSmooth;
}

void OrganView::resizeEvent(QResizeEvent*) {
    m_isStale = true;
    if (showsWholeOrgan()) frameOrgan();
}

/// Turned it still does.
bool OrganView::showsWholeOrgan() const {
    if (!m_whole || isWithin()) return false;
    constexpr double same = 1e-6;
    const double distance = (m_whole->eye - m_whole->target).norm();
    const Camera& now = camera();
    return (now.target - m_whole->target).norm() < same * distance &&
           std::abs((now.eye - now.target).norm() - distance) < same * distance &&
           now.orthographicHeight == m_whole->orthographicHeight;
}

/// Above the place that is nearest to what is looked at: the middle of a long shaft may lie beyond the
/// picture.
void OrganView::nameInstruments(QPainter& painter, const Camera& shown) {
    const Sight sight{m_scene, shown, size(), m_picker};
    const Eigen::Vector3d up = cameraAxes(shown).col(1);
    for (std::size_t i = 0; i < m_scene.instruments.size() && int(i) < m_instrumentNames.size(); ++i) {
        const PlacedCollider& instrument = m_scene.instruments[i];
        const ColliderAxis axis = axisOf(instrument);
        const Eigen::Vector3d nearest = axis.at(axis.nearest(shown.target));
        if (const auto place = sight.placeOf(nearest + radiusOf(instrument.shape) * up))
            paintLabel(painter, *place, m_instrumentNames[int(i)], palette());
    }
}

void OrganView::paintEvent(QPaintEvent*) {
    // A move to another screen says nothing else.
    if (m_isStale || m_askedRatio != devicePixelRatioF()) askForPicture();
    QPainter painter(this);
    if (m_picture.image.isNull()) painter.fillRect(rect(), palette().color(QPalette::Window));
    if (m_picture.problem.isEmpty()) {
        painter.drawImage(rect(), m_picture.image);
        return paintOverlay(painter);
    }
    painter.setPen(palette().color(QPalette::WindowText));
    painter.drawText(rect().adjusted(20, 20, -20, -20), Qt::AlignCenter | Qt::TextWordWrap,
                     tr("The organ cannot be shown: %1").arg(m_picture.problem));
}

/// What lies over the picture goes by the camera that the picture was made with, lest it swim on it.
void OrganView::paintOverlay(QPainter& painter) {
    painter.setRenderHint(QPainter::Antialiasing);
    const OverlayStyle style{size(), palette()};
    const Camera& shown = m_picture.image.isNull() ? camera() : m_picture.camera;
    nameInstruments(painter, shown);
    m_tool->draw(painter, {m_scene, shown, size(), m_picker}, style.palette);
    if (m_legend) paintLegend(painter, style, *m_legend);
    paintHint(painter, style, m_hint, m_legend ? &*m_legend : nullptr);
    paintAxisCube(painter, shown, cubeSquare(size()), style.palette);
    m_keyPointer.paintFocus(painter);
}

} // namespace esm
