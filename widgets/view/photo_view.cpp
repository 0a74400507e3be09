#include "widgets/view/photo_view.h"

#include "widgets/texture/image_conversion.h"
#include "widgets/view/camera_controller.h"
#include "widgets/view/overlay.h"

#include <QMouseEvent>

#include <algorithm>
#include <cmath>

namespace esm {

namespace {

using Eigen::Vector2d;

constexpr double photoMargin = 12;    // pixels around the whole photo
constexpr double photoClickReach = 4; // pixels a click may wander before it is a drag
constexpr double perNotch = 1.25;     // closer
constexpr double largestPixel = 32;   // pixels of the widget that one of the photo may fill
constexpr double smoothUpToScale = 3; // beyond it pixels are shown as they are, to be hit

} // namespace

PhotoView::PhotoView(QWidget* parent) : QWidget(parent) {
    setMinimumSize(200, 180);
    setMouseTracking(true);
    setCursor(Qt::CrossCursor);
    setObjectName(QStringLiteral("photoView"));
    setAccessibleName(tr("Photo"));
    setToolTip(tr("Click a place, drag a mark or the photo, and come closer with the wheel"));
    setFocusPolicy(Qt::StrongFocus);
    m_keyPointer.setStops([this] {
        std::vector<QPointF> stops;
        for (const PhotoMark& mark : m_marks)
            stops.push_back(placeOf(mark.place));
        return stops;
    });
}

void PhotoView::setPicture(std::shared_ptr<const Image> picture) {
    if (picture == m_picture) return;
    const bool isAnother =
        !picture || !m_picture || picture->width != m_picture->width || picture->height != m_picture->height;
    m_picture = std::move(picture);
    m_image = m_picture && !m_picture->empty() ? toQImage(*m_picture) : QImage();
    if (isAnother) {
        m_closeness = 1;
        setMiddle(Vector2d(m_image.width(), m_image.height()) / 2);
    }
    update();
}

void PhotoView::setMarks(std::vector<PhotoMark> marks) {
    m_marks = std::move(marks);
    tellSpoken(*this);
    update();
}

void PhotoView::setHint(const QString& hint) {
    m_hint = hint;
    update();
}

QString PhotoView::spokenValue() const {
    if (m_image.isNull()) return tr("no photo");
    const QString size = tr("%1 × %2 pixels").arg(m_image.width()).arg(m_image.height());
    return tr("%1, %2 marks. %3").arg(size).arg(m_marks.size()).arg(m_hint);
}

double PhotoView::scale() const {
    if (m_image.isNull()) return 1;
    const double whole = std::min((width() - 2 * photoMargin) / m_image.width(),
                                  (height() - 2 * photoMargin) / m_image.height());
    return std::max(whole, 1e-3) * m_closeness;
}

QPointF PhotoView::placeOf(const Vector2d& pixel) const {
    const Vector2d way = scale() * (pixel - m_middle);
    return QPointF(width() / 2.0 + way.x(), height() / 2.0 + way.y());
}

Vector2d PhotoView::pixelAt(const QPointF& place) const {
    return m_middle + Vector2d(place.x() - width() / 2.0, place.y() - height() / 2.0) / scale();
}

/// As much of the photo as fits stays in sight.
void PhotoView::setMiddle(const Vector2d& pixel) {
    const Vector2d size(m_image.width(), m_image.height());
    const Vector2d seen = Vector2d(width() - 2 * photoMargin, height() - 2 * photoMargin) / (2 * scale());
    for (int axis : {0, 1})
        m_middle[axis] = 2 * seen[axis] >= size[axis]
                             ? size[axis] / 2
                             : std::clamp(pixel[axis], seen[axis], size[axis] - seen[axis]);
    update();
}

bool PhotoView::holds(const Vector2d& pixel) const {
    return pixel.x() >= 0 && pixel.y() >= 0 && pixel.x() <= m_image.width() && pixel.y() <= m_image.height();
}

std::vector<PaintedMark> PhotoView::paintedMarks() const {
    std::vector<PaintedMark> painted;
    for (const PhotoMark& mark : m_marks)
        painted.push_back({placeOf(mark.place), mark.look});
    return painted;
}

void PhotoView::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), palette().color(QPalette::Window));
    painter.setRenderHint(QPainter::SmoothPixmapTransform, scale() < smoothUpToScale);
    const Vector2d end(m_image.width(), m_image.height());
    if (!m_image.isNull()) painter.drawImage(QRectF(placeOf({0, 0}), placeOf(end)), m_image);
    paintMarks(painter, paintedMarks(), palette());
    paintHint(painter, {size(), palette()}, m_hint);
    m_keyPointer.paintFocus(painter);
}

void PhotoView::mousePressEvent(QMouseEvent* event) {
    if (m_image.isNull()) return;
    m_pressed = event->localPos();
    if (event->button() == Qt::LeftButton) m_dragged = markAt(paintedMarks(), event->localPos());
    if (!m_dragged) m_shiftFrom = event->localPos();
}

/// A press is a click until it has wandered a few pixels; from then on it is a drag, and no click comes of
/// it. A hand that trembles sets a mark and does not shift the photo.
void PhotoView::mouseMoveEvent(QMouseEvent* event) {
    const QPointF place = event->localPos();
    if (m_pressed && std::hypot(place.x() - m_pressed->x(), place.y() - m_pressed->y()) > photoClickReach)
        m_pressed.reset();
    if (m_pressed) return;
    if (m_dragged) {
        const Vector2d pixel = pixelAt(place);
        emit markDragged(*m_dragged, {std::clamp<double>(pixel.x(), 0, m_image.width()),
                                      std::clamp<double>(pixel.y(), 0, m_image.height())});
    } else if (m_shiftFrom) {
        setMiddle(m_middle - (pixelAt(place) - pixelAt(*m_shiftFrom)));
        m_shiftFrom = place;
    } else {
        setCursor(markAt(paintedMarks(), place) ? Qt::PointingHandCursor : Qt::CrossCursor);
    }
}

void PhotoView::mouseReleaseEvent(QMouseEvent* event) {
    const bool isClick = m_pressed && event->button() == Qt::LeftButton;
    const std::optional<int> mark = m_dragged;
    drop();
    if (!isClick) return;
    const Vector2d pixel = pixelAt(event->localPos());
    if (mark)
        emit markSelected(*mark);
    else if (holds(pixel))
        emit pixelPicked(pixel);
}

bool PhotoView::letGo() {
    const bool hadMark = m_dragged.has_value();
    m_pressed.reset();
    m_dragged.reset();
    m_shiftFrom.reset();
    return hadMark;
}

void PhotoView::drop() {
    const bool moved = m_dragged && !m_pressed;
    m_pressed.reset();
    m_dragged.reset();
    m_shiftFrom.reset();
    if (moved) emit markDropped();
}

/// The pixel under the pointer stays there: the middle is moved by what the zoom has shifted it.
void PhotoView::wheelEvent(QWheelEvent* event) {
    if (m_image.isNull()) return;
    const Vector2d under = pixelAt(event->position());
    const double closest = std::max(1.0, largestPixel * m_closeness / scale());
    m_closeness = std::clamp(m_closeness * std::pow(perNotch, wheelNotches(*event)), 1.0, closest);
    setMiddle(m_middle + under - pixelAt(event->position()));
    event->accept();
}

void PhotoView::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    setMiddle(m_middle);
}

void PhotoView::keyPressEvent(QKeyEvent* event) {
    if (!m_keyPointer.press(*event)) QWidget::keyPressEvent(event);
}

bool PhotoView::focusNextPrevChild(bool next) {
    return m_keyPointer.goToNextStop(next) || QWidget::focusNextPrevChild(next);
}

} // namespace esm
