#pragma once

#include "core/texture/photo/photo_preparation.h"
#include "core/texture/photo/straightening.h"
#include "widgets/inputs/key_pointer.h"
#include "widgets/inputs/spoken.h"

#include <QImage>
#include <QWidget>

#include <optional>

namespace esm {

/// What the mouse does on a photo.
enum class PhotoTool { LeaveOut, TakeBack, Straighten, Crop };

/// A photo, as large as there is room, to paint on, to draw lines on and to frame. It says what was drawn, in
/// photo pixels, and shows what it is told. The wheel magnifies about the mouse; the middle button moves the
/// photo.
class PhotoCanvas : public QWidget, public Spoken {
    Q_OBJECT

public:
    explicit PhotoCanvas(QWidget* parent = nullptr);

    void setPicture(const QImage& picture);
    void setStrokes(const std::vector<PhotoStroke>& strokes);
    void setCrop(const std::optional<PhotoCrop>& crop);
    void setTool(PhotoTool tool);
    /// @param radius photo pixels
    /// @param softness share of the radius, 0 to 1
    void setBrush(double radius, double softness);

    PhotoTool tool() const { return m_tool; }
    /// Lines of three places and more that were drawn, the one at work included.
    std::vector<DrawnLine> lines() const;
    void clearLines();

    /// The photo's size, and what was drawn on it.
    QString spokenValue() const override;

    QPointF toWidget(const Eigen::Vector2d& place) const;
    Eigen::Vector2d toPhoto(const QPointF& at) const;

signals:
    void strokeDrawn(const esm::PhotoStroke& stroke);
    void linesChanged();
    /// The frame while it is drawn; frameFinished() when it is let go.
    void cropDrawn(const esm::PhotoCrop& crop);
    void frameFinished();
    /// Esc while the frame is drawn: how it was before.
    void frameDropped(const std::optional<esm::PhotoCrop>& before);

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void leaveEvent(QEvent* event) override;

private:
    bool isBrush() const { return m_tool == PhotoTool::LeaveOut || m_tool == PhotoTool::TakeBack; }
    double fittingScale() const;
    void fit();
    void place(double scale, const QPointF& origin);
    void redraw();
    void drawStroke(QPainter& painter, const PhotoStroke& stroke) const;
    void paintStrokes(QPainter& painter) const;
    void paintLines(QPainter& painter) const;
    void paintCrop(QPainter& painter) const;
    void endLine();
    void beginFrame(const QPointF& at);
    void dragFrame(const Eigen::Vector2d& to);
    /// Of what the mouse draws; false where it draws nothing.
    bool dropDrawn();

    QImage m_picture;
    QPixmap m_shown;  ///< the picture as the view has it
    QImage m_overlay; ///< what the strokes leave out, likewise
    std::vector<PhotoStroke> m_strokes;
    std::optional<PhotoStroke> m_stroke; ///< at work
    std::vector<DrawnLine> m_lines;      ///< the last one is at work; may be empty
    std::optional<PhotoCrop> m_crop;
    std::optional<Eigen::Vector2d> m_frameCorner; ///< opposite to the one that is dragged
    std::optional<PhotoCrop> m_cropBefore;        ///< that drag
    std::optional<QPointF> m_mouse, m_panned;
    PhotoTool m_tool = PhotoTool::LeaveOut;
    double m_radius = 20, m_softness = 0;
    double m_scale = 1; ///< widget pixels per photo pixel
    QPointF m_origin;   ///< the photo's top left corner, widget pixels
    KeyPointer m_keyPointer{*this};
};

} // namespace esm
