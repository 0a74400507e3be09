#pragma once

#include "core/texture/image.h"
#include "widgets/inputs/key_pointer.h"
#include "widgets/inputs/spoken.h"
#include "widgets/view/marks.h"

#include <Eigen/Core>
#include <QImage>
#include <QWidget>

#include <memory>
#include <optional>
#include <vector>

namespace esm {

/// A place in a photo, in pixels from its top left corner.
struct PhotoMark {
    Eigen::Vector2d place;
    MarkLook look;
};

/// A photo in which places are chosen to the pixel: the wheel comes closer where the mouse is, a drag shifts,
/// a click chooses a place, and a mark follows a drag. Knows no document: nothing moves until new marks say
/// so.
class PhotoView : public QWidget, public Spoken {
    Q_OBJECT

public:
    explicit PhotoView(QWidget* parent = nullptr);

    /// Shows the whole of another photo; null for none.
    void setPicture(std::shared_ptr<const Image> picture);
    void setMarks(std::vector<PhotoMark> marks);
    /// The line at the bottom.
    void setHint(const QString& hint);
    const QString& hint() const { return m_hint; }

    /// Ends a drag of a mark, which stays where its owner puts it; false where there was none.
    bool letGo();

    /// The photo's size and how many places are marked.
    QString spokenValue() const override;

    /// Between the widget and the photo, both in pixels.
    QPointF placeOf(const Eigen::Vector2d& pixel) const;
    Eigen::Vector2d pixelAt(const QPointF& place) const;

signals:
    void pixelPicked(const Eigen::Vector2d& pixel);
    void markSelected(int number);
    /// Where the drag takes a mark; again and again until `markDropped`.
    void markDragged(int number, const Eigen::Vector2d& pixel);
    void markDropped();

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    bool focusNextPrevChild(bool next) override;

private:
    double scale() const; ///< pixels of the widget per pixel of the photo
    void setMiddle(const Eigen::Vector2d& pixel);
    bool holds(const Eigen::Vector2d& pixel) const;
    std::vector<PaintedMark> paintedMarks() const;
    void drop();

    std::shared_ptr<const Image> m_picture;
    QImage m_image;
    std::vector<PhotoMark> m_marks;
    QString m_hint;
    double m_closeness = 1;             ///< 1 shows the whole photo
    Eigen::Vector2d m_middle{0, 0};     ///< the photo's pixel in the widget's middle
    std::optional<QPointF> m_pressed;   ///< where a button went down, while it may still become a click
    std::optional<int> m_dragged;       ///< the number of the mark that follows the mouse
    std::optional<QPointF> m_shiftFrom; ///< where the mouse was that shifts the photo
    KeyPointer m_keyPointer{*this};
};

} // namespace esm
