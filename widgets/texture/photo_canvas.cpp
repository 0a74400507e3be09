#include "widgets/texture/photo_canvas.h"

#include "widgets/texture/crop_tool.h"
#include "widgets/texture/field_tool.h"
#include "widgets/texture/line_tool.h"
#include "widgets/texture/mask_tools.h"

#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>

namespace esm {

namespace {

constexpr double mostMagnified = 16;
constexpr int edge = 8; ///< widget pixels around the photo

/// Of what is erased: undyed tissue, blood, fat and steel are far from it.
constexpr QRgb erasedColour = 0xff2f7dff;

QColor amber(const QWidget& widget) {
    return widget.palette().color(QPalette::LinkVisited);
}

/// The way of a brush; a dab is a very short one.
QPainterPath pathOf(const std::vector<Eigen::Vector2d>& places) {
    QPainterPath path;
    path.moveTo(places.front().x(), places.front().y());
    for (const Eigen::Vector2d& place : places)
        path.lineTo(place.x() + 1e-3, place.y());
    return path;
}

FieldTool::Shape shapeOf(FieldShape shape, bool isCircle) {
    if (shape == FieldShape::Polygon) return FieldTool::Shape::Polygon;
    return isCircle ? FieldTool::Shape::Circle : FieldTool::Shape::Ellipse;
}

std::unique_ptr<CanvasTool> makeTool(PhotoTool tool, PhotoCanvas& canvas) {
    switch (tool) {
    case PhotoTool::Field:
        return std::make_unique<FieldTool>(canvas);
    case PhotoTool::LeaveOut:
        return std::make_unique<MaskBrush>(canvas, false);
    case PhotoTool::TakeBack:
        return std::make_unique<MaskBrush>(canvas, true);
    case PhotoTool::Outline:
        return std::make_unique<MaskOutline>(canvas);
    case PhotoTool::Box:
        return std::make_unique<MaskBox>(canvas);
    case PhotoTool::Pick:
        return std::make_unique<PlacePicker>(canvas);
    case PhotoTool::Straighten:
        return std::make_unique<LineTool>(canvas);
    case PhotoTool::Crop:
        return std::make_unique<CropTool>(canvas);
    }
    return nullptr;
}

} // namespace

PhotoCanvas::PhotoCanvas(QWidget* parent) : QWidget(parent) {
    setObjectName(QStringLiteral("photoCanvas"));
    setAccessibleName(tr("Photo"));
    setToolTip(tr("The wheel comes closer, the middle button shifts the photo"));
    setMinimumSize(320, 240);
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    setCursor(Qt::CrossCursor);
    m_tool = makeTool(m_kind, *this);
}

PhotoCanvas::~PhotoCanvas() = default;

void PhotoCanvas::setPicture(const QImage& picture) {
    const bool isAnother = picture.size() != m_picture.size();
    m_picture = picture;
    if (isAnother) {
        clearLines();
        fit();
    } else {
        redraw();
    }
}

void PhotoCanvas::setStrokes(const std::vector<PhotoStroke>& strokes) {
    if (strokes == m_strokes) return;
    m_strokes = strokes;
    tellSpoken(*this);
    redraw();
}

void PhotoCanvas::setCrop(const std::optional<PhotoCrop>& crop) {
    m_crop = crop;
    tellSpoken(*this);
    update();
}

void PhotoCanvas::setField(const std::optional<PhotoField>& field) {
    m_field = field;
    tellSpoken(*this);
    update();
}

void PhotoCanvas::setMarked(const QImage& mask) {
    m_marked = mask;
    update();
}

void PhotoCanvas::setTool(PhotoTool tool) {
    m_kind = tool;
    m_tool.reset(); // before the next is made: it may leave something behind
    m_tool = makeTool(tool, *this);
    setFieldShape(m_fieldShape, m_isCircle);
    emit linesChanged();
    update();
}

void PhotoCanvas::setBrush(const PhotoBrush& brush) {
    m_brush = brush;
    update();
}

void PhotoCanvas::setFieldShape(FieldShape shape, bool isCircle) {
    m_fieldShape = shape;
    m_isCircle = isCircle;
    if (auto* field = dynamic_cast<FieldTool*>(m_tool.get())) field->setShape(shapeOf(shape, isCircle));
    update();
}

std::vector<DrawnLine> PhotoCanvas::lines() const {
    std::vector<DrawnLine> lines;
    std::copy_if(m_lines.begin(), m_lines.end(), std::back_inserter(lines),
                 [](const DrawnLine& line) { return line.size() >= 3; });
    return lines;
}

void PhotoCanvas::clearLines() {
    m_lines.clear();
    emit linesChanged();
    update();
}

QString PhotoCanvas::spokenValue() const {
    if (m_picture.isNull()) return tr("no photo");
    QStringList said{tr("%1 × %2 pixels").arg(m_picture.width()).arg(m_picture.height()),
                     tr("%1 strokes").arg(m_strokes.size()), tr("%1 lines").arg(lines().size())};
    if (m_crop)
        said << tr("cropped to %1 × %2 pixels from %3, %4")
                    .arg(m_crop->width)
                    .arg(m_crop->height)
                    .arg(m_crop->x)
                    .arg(m_crop->y);
    if (m_field) said << tr("with a field");
    return said.join(QStringLiteral(", "));
}

QPointF PhotoCanvas::toWidget(const Eigen::Vector2d& place) const {
    return m_origin + QPointF(place.x(), place.y()) * m_scale;
}

Eigen::Vector2d PhotoCanvas::toPhoto(const QPointF& at) const {
    const QPointF place = (at - m_origin) / m_scale;
    return {place.x(), place.y()};
}

double PhotoCanvas::fittingScale() const {
    if (m_picture.isNull()) return 1;
    return std::min((width() - 2.0 * edge) / m_picture.width(), (height() - 2.0 * edge) / m_picture.height());
}

void PhotoCanvas::fit() {
    const double scale = fittingScale();
    place(scale,
          {0.5 * (width() - scale * m_picture.width()), 0.5 * (height() - scale * m_picture.height())});
}

void PhotoCanvas::place(double scale, const QPointF& origin) {
    m_scale = scale;
    m_origin = origin;
    redraw();
}

/// Draws anew what does not change while the mouse moves.
void PhotoCanvas::redraw() {
    m_shown = QPixmap(size());
    m_shown.fill(palette().color(QPalette::Window));
    m_overlay = QImage(size(), QImage::Format_ARGB32_Premultiplied);
    m_overlay.fill(Qt::transparent);
    if (!m_picture.isNull()) {
        QPainter painter(&m_shown);
        painter.setRenderHint(QPainter::SmoothPixmapTransform, m_scale < 2);
        painter.drawImage(QRectF(m_origin, QSizeF(m_picture.size()) * m_scale), m_picture);
        QPainter over(&m_overlay);
        over.setRenderHint(QPainter::Antialiasing);
        over.setClipRect(QRectF(m_origin, QSizeF(m_picture.size()) * m_scale));
        for (const PhotoStroke& stroke : m_strokes)
            drawStroke(over, stroke);
    }
    update();
}

/// Soft ones as wide as half of the brush lies on them.
void PhotoCanvas::drawStroke(QPainter& painter, const PhotoStroke& stroke) const {
    painter.save();
    painter.translate(m_origin);
    painter.scale(m_scale, m_scale);
    painter.setCompositionMode(stroke.takesBack ? QPainter::CompositionMode_DestinationOut
                                                : QPainter::CompositionMode_SourceOver);
    const double wide = 2 * stroke.radius * (1 - 0.5 * stroke.softness);
    painter.setPen(QPen(QColor(erasedColour), wide, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    QPainterPath path = pathOf(stroke.path);
    if (stroke.isFilled) {
        path.closeSubpath();
        path.setFillRule(Qt::WindingFill);
        painter.setBrush(QColor(erasedColour));
    }
    painter.drawPath(path);
    painter.restore();
}

bool PhotoCanvas::isAt(const Eigen::Vector2d& place, const QPointF& at) const {
    return QLineF(toWidget(place), at).length() <= grip;
}

void PhotoCanvas::addStroke(const PhotoStroke& stroke) {
    m_strokes.push_back(stroke);
    redraw();
    emit strokeDrawn(stroke);
}

QPainterPath PhotoCanvas::rimOf(const PhotoField& field) const {
    QPolygonF rim;
    for (const Eigen::Vector2d& place : outlineOf(field, false))
        rim << toWidget(place);
    QPainterPath path;
    path.addPolygon(rim);
    path.closeSubpath();
    return path;
}

void PhotoCanvas::drawKept(QPainter& painter, const QPainterPath& inside) const {
    QPainterPath outside;
    outside.addRect(QRectF(m_origin, QSizeF(m_picture.size()) * m_scale));
    painter.fillPath(outside - inside, QColor(0, 0, 0, 150));
    painter.strokePath(inside, QPen(amber(*this), 1.5));
}

void PhotoCanvas::drawHandle(QPainter& painter, const Eigen::Vector2d& place) const {
    painter.setPen(QPen(Qt::black, 1));
    painter.setBrush(Qt::white);
    painter.drawRect(QRectF(toWidget(place) - QPointF(4, 4), QSizeF(8, 8)));
}

void PhotoCanvas::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.drawPixmap(0, 0, m_shown);
    painter.setRenderHint(QPainter::Antialiasing);
    if (m_picture.isNull()) return;
    painter.setOpacity(0.6);
    painter.drawImage(0, 0, m_overlay);
    if (!m_marked.isNull()) painter.drawImage(QRectF(m_origin, QSizeF(m_picture.size()) * m_scale), m_marked);
    painter.setOpacity(1);
    if (m_field) drawKept(painter, rimOf(*m_field));
    m_tool->paint(painter);
    if (m_mouse) m_tool->paintCursor(painter, *m_mouse);
    m_keyPointer.paintFocus(painter);
}

void PhotoCanvas::resizeEvent(QResizeEvent*) {
    fit();
}

void PhotoCanvas::mousePressEvent(QMouseEvent* event) {
    if (event->button() == Qt::MiddleButton) m_panned = event->localPos();
    if (event->button() == Qt::RightButton) m_tool->finish();
    if (event->button() == Qt::LeftButton && !m_picture.isNull()) m_tool->press(*event);
    update();
}

void PhotoCanvas::mouseMoveEvent(QMouseEvent* event) {
    const QPointF at = event->localPos();
    m_mouse = at;
    if (m_panned && event->buttons().testFlag(Qt::MiddleButton)) {
        place(m_scale, m_origin + at - *m_panned);
        m_panned = at;
    } else if (event->buttons().testFlag(Qt::LeftButton)) {
        m_tool->drag(*event);
    }
    update();
}

void PhotoCanvas::mouseReleaseEvent(QMouseEvent* event) {
    m_panned.reset();
    if (event->button() == Qt::LeftButton) m_tool->release();
    update();
}

/// The first click of the two was a press already.
void PhotoCanvas::mouseDoubleClickEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton || !m_tool->finish()) mousePressEvent(event);
    update();
}

void PhotoCanvas::wheelEvent(QWheelEvent* event) {
    const double smallest = fittingScale();
    const double scale =
        std::clamp(m_scale * std::pow(1.2, event->angleDelta().y() / 120.0), smallest, mostMagnified);
    event->accept();
    if (scale <= smallest) {
        fit();
        return;
    }
    const QPointF at = event->position();
    place(scale, at - (at - m_origin) * (scale / m_scale));
}

void PhotoCanvas::keyPressEvent(QKeyEvent* event) {
    // Enter sets a place where the mark is seen; with Ctrl it ends the line there too.
    if (!event->modifiers().testFlag(Qt::ControlModifier) && m_keyPointer.press(*event)) return;
    if (!toolTakes(*event)) QWidget::keyPressEvent(event);
    update();
}

bool PhotoCanvas::toolTakes(const QKeyEvent& event) {
    switch (event.key()) {
    case Qt::Key_Return:
    case Qt::Key_Enter:
        return m_tool->finish();
    case Qt::Key_Backspace:
    case Qt::Key_Delete:
        return m_tool->takeBack();
    case Qt::Key_Escape:
        return m_tool->drop();
    default:
        return false;
    }
}

void PhotoCanvas::leaveEvent(QEvent*) {
    m_mouse.reset();
    update();
}

} // namespace esm
