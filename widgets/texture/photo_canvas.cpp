#include "widgets/texture/photo_canvas.h"

#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>

namespace esm {

namespace {

constexpr double grip = 9; ///< widget pixels within which a corner is taken
constexpr double mostMagnified = 16;
constexpr int edge = 8; ///< widget pixels around the photo

QColor amber(const QWidget& widget) {
    return widget.palette().color(QPalette::LinkVisited);
}

std::array<Eigen::Vector2d, 4> cornersOf(const PhotoCrop& crop) {
    const double left = crop.x, top = crop.y, right = left + crop.width, bottom = top + crop.height;
    return {Eigen::Vector2d(left, top), Eigen::Vector2d(right, top), Eigen::Vector2d(right, bottom),
            Eigen::Vector2d(left, bottom)};
}

/// The way of a brush; a dab is a very short one.
QPainterPath pathOf(const std::vector<Eigen::Vector2d>& places) {
    QPainterPath path;
    path.moveTo(places.front().x(), places.front().y());
    for (const Eigen::Vector2d& place : places)
        path.lineTo(place.x() + 1e-3, place.y());
    return path;
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
}

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

void PhotoCanvas::setTool(PhotoTool tool) {
    m_tool = tool;
    m_stroke.reset();
    m_frameCorner.reset();
    if (!m_lines.empty()) m_lines.back().clear(); // what was not ended
    emit linesChanged();
    update();
}

void PhotoCanvas::setBrush(double radius, double softness) {
    m_radius = radius;
    m_softness = softness;
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
    painter.setPen(QPen(amber(*this), wide, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPath(pathOf(stroke.path));
    painter.restore();
}

void PhotoCanvas::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.drawPixmap(0, 0, m_shown);
    painter.setRenderHint(QPainter::Antialiasing);
    if (m_picture.isNull()) return;
    paintStrokes(painter);
    if (m_tool == PhotoTool::Straighten) paintLines(painter);
    if (m_tool == PhotoTool::Crop) paintCrop(painter);
    if (isBrush() && m_mouse) {
        painter.setBrush(Qt::NoBrush);
        for (const auto& [colour, by] : {std::pair(QColor(Qt::black), 1.0), {QColor(Qt::white), 0.0}}) {
            painter.setPen(QPen(colour, 1));
            painter.drawEllipse(*m_mouse, m_radius * m_scale + by, m_radius * m_scale + by);
        }
    }
    m_keyPointer.paintFocus(painter);
}

void PhotoCanvas::paintStrokes(QPainter& painter) const {
    QImage overlay = m_overlay;
    if (m_stroke) {
        QPainter over(&overlay);
        over.setRenderHint(QPainter::Antialiasing);
        drawStroke(over, *m_stroke);
    }
    painter.setOpacity(0.6);
    painter.drawImage(0, 0, overlay);
    painter.setOpacity(1);
}

void PhotoCanvas::paintLines(QPainter& painter) const {
    const QColor colour = palette().color(QPalette::Highlight).lighter(140);
    for (const DrawnLine& line : m_lines) {
        QPolygonF points;
        for (const Eigen::Vector2d& place : line)
            points << toWidget(place);
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(colour, 1.5));
        painter.drawPolyline(points);
        painter.setBrush(colour);
        painter.setPen(QPen(Qt::black, 1));
        for (const QPointF& point : points)
            painter.drawEllipse(point, 4, 4);
    }
}

void PhotoCanvas::paintCrop(QPainter& painter) const {
    if (!m_crop) return;
    const auto corners = cornersOf(*m_crop);
    const QRectF frame(toWidget(corners[0]), toWidget(corners[2]));
    QPainterPath outside;
    outside.addRect(QRectF(m_origin, QSizeF(m_picture.size()) * m_scale));
    QPainterPath inside;
    inside.addRect(frame);
    painter.fillPath(outside - inside, QColor(0, 0, 0, 150));
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(amber(*this), 1.5));
    painter.drawRect(frame);
    painter.setBrush(Qt::white);
    for (const Eigen::Vector2d& corner : corners)
        painter.drawRect(QRectF(toWidget(corner) - QPointF(4, 4), QSizeF(8, 8)));
}

void PhotoCanvas::resizeEvent(QResizeEvent*) {
    fit();
}

void PhotoCanvas::mousePressEvent(QMouseEvent* event) {
    const QPointF at = event->localPos();
    if (event->button() == Qt::MiddleButton) m_panned = at;
    if (event->button() == Qt::RightButton && m_tool == PhotoTool::Straighten) endLine();
    if (event->button() != Qt::LeftButton || m_picture.isNull()) return;
    if (isBrush()) {
        m_stroke = PhotoStroke{{toPhoto(at)}, m_radius, m_softness, m_tool == PhotoTool::TakeBack};
    } else if (m_tool == PhotoTool::Straighten) {
        if (m_lines.empty()) m_lines.emplace_back();
        m_lines.back().push_back(toPhoto(at));
        emit linesChanged();
    } else {
        beginFrame(at);
    }
    update();
}

void PhotoCanvas::mouseMoveEvent(QMouseEvent* event) {
    const QPointF at = event->localPos();
    m_mouse = at;
    if (m_panned && event->buttons().testFlag(Qt::MiddleButton)) {
        place(m_scale, m_origin + at - *m_panned);
        m_panned = at;
    } else if (event->buttons().testFlag(Qt::LeftButton)) {
        // Places nearer to each other than an eighth of the brush draw the same.
        const double nearest = std::max(1.0, m_radius / 8);
        if (m_stroke && (toPhoto(at) - m_stroke->path.back()).norm() >= nearest)
            m_stroke->path.push_back(toPhoto(at));
        if (m_frameCorner) dragFrame(toPhoto(at));
    }
    update();
}

void PhotoCanvas::mouseReleaseEvent(QMouseEvent* event) {
    m_panned.reset();
    if (event->button() != Qt::LeftButton) return;
    if (m_stroke) {
        const PhotoStroke stroke = *m_stroke;
        m_stroke.reset();
        m_strokes.push_back(stroke); // until it is told otherwise
        redraw();
        emit strokeDrawn(stroke);
    }
    if (m_frameCorner) {
        m_frameCorner.reset();
        emit frameFinished();
    }
}

void PhotoCanvas::mouseDoubleClickEvent(QMouseEvent* event) {
    // The first click of the two set a place already.
    if (m_tool == PhotoTool::Straighten && event->button() == Qt::LeftButton)
        endLine();
    else
        mousePressEvent(event);
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
    const bool draws = m_tool == PhotoTool::Straighten && !m_lines.empty();
    const int key = event->key();
    if (draws && (key == Qt::Key_Return || key == Qt::Key_Enter)) {
        endLine();
    } else if (draws && key == Qt::Key_Backspace) {
        if (!m_lines.back().empty()) m_lines.back().pop_back();
        if (m_lines.back().empty()) m_lines.pop_back();
        emit linesChanged();
        update();
    } else if (key != Qt::Key_Escape || !dropDrawn()) {
        QWidget::keyPressEvent(event);
    }
}

bool PhotoCanvas::dropDrawn() {
    if (!m_stroke && !m_frameCorner) return false;
    m_stroke.reset();
    if (m_frameCorner) {
        m_frameCorner.reset();
        emit frameDropped(m_cropBefore);
    }
    update();
    return true;
}

void PhotoCanvas::leaveEvent(QEvent*) {
    m_mouse.reset();
    update();
}

void PhotoCanvas::endLine() {
    if (!m_lines.empty() && !m_lines.back().empty()) m_lines.emplace_back();
    emit linesChanged();
    update();
}

/// Takes the frame by a corner, or begins another one.
void PhotoCanvas::beginFrame(const QPointF& at) {
    m_cropBefore = m_crop;
    if (m_crop) {
        const auto corners = cornersOf(*m_crop);
        for (std::size_t i = 0; i < corners.size(); ++i)
            if (QLineF(toWidget(corners[i]), at).length() <= grip) {
                m_frameCorner = corners[(i + 2) % corners.size()];
                return;
            }
    }
    m_frameCorner = toPhoto(at);
}

void PhotoCanvas::dragFrame(const Eigen::Vector2d& to) {
    const auto within = [](double place, int size) {
        return static_cast<int>(std::lround(std::clamp(place, 0.0, static_cast<double>(size))));
    };
    const Eigen::Vector2d low = m_frameCorner->cwiseMin(to), high = m_frameCorner->cwiseMax(to);
    const int left = within(low.x(), m_picture.width()), right = within(high.x(), m_picture.width());
    const int top = within(low.y(), m_picture.height()), bottom = within(high.y(), m_picture.height());
    if (right - left < 2 || bottom - top < 2) return;
    m_crop = PhotoCrop{left, top, right - left, bottom - top};
    emit cropDrawn(*m_crop);
}

} // namespace esm
