#pragma once

#include "core/texture/photo/photo_preparation.h"
#include "core/texture/photo/straightening.h"
#include "widgets/inputs/key_pointer.h"
#include "widgets/inputs/spoken.h"

#include <QImage>
#include <QPainterPath>
#include <QWidget>

#include <memory>
#include <optional>

namespace esm {

class CanvasTool;

/// What the mouse does on a photo.
enum class PhotoTool { Field, LeaveOut, TakeBack, Outline, Box, Pick, Straighten, Crop };

struct PhotoBrush {
    double radius = 20;  ///< photo pixels
    double softness = 0; ///< share of the radius, 0 to 1
};

/// A photo, as large as there is room, to paint on, to draw lines on and to frame. A tool draws, and the
/// canvas says what was drawn, in photo pixels, and shows what it is told. The wheel magnifies about the
/// mouse; the middle button moves the photo.
class PhotoCanvas : public QWidget, public Spoken {
    Q_OBJECT

public:
    static constexpr int grip = 9; ///< widget pixels within which a handle is taken

    explicit PhotoCanvas(QWidget* parent = nullptr);
    ~PhotoCanvas() override;

    void setPicture(const QImage& picture);
    void setStrokes(const std::vector<PhotoStroke>& strokes);
    void setCrop(const std::optional<PhotoCrop>& crop);
    void setField(const std::optional<PhotoField>& field);
    /// A mask that is shown over the photo, of its size; null: none.
    void setMarked(const QImage& mask);
    void setTool(PhotoTool tool);
    void setBrush(const PhotoBrush& brush);
    /// What is drawn where there is no field, and how one is mended.
    void setFieldShape(FieldShape shape, bool isCircle);

    PhotoTool tool() const { return m_kind; }
    const PhotoBrush& brush() const { return m_brush; }
    const std::optional<PhotoCrop>& crop() const { return m_crop; }
    const std::optional<PhotoField>& field() const { return m_field; }
    QSize photoSize() const { return m_picture.size(); }
    /// Lines of three places and more that were drawn, the one at work included.
    std::vector<DrawnLine> lines() const;
    void clearLines();

    /// The photo's size, and what was drawn on it.
    QString spokenValue() const override;

    QPointF toWidget(const Eigen::Vector2d& place) const;
    Eigen::Vector2d toPhoto(const QPointF& at) const;
    double magnification() const { return m_scale; } ///< widget pixels per photo pixel

    // For tools.
    std::vector<DrawnLine>& drawnLines() { return m_lines; } ///< the last one is at work; may be empty
    bool isAt(const Eigen::Vector2d& place, const QPointF& at) const;
    void addStroke(const PhotoStroke& stroke); ///< shown until it is told otherwise
    void drawStroke(QPainter& painter, const PhotoStroke& stroke) const;
    /// What is kept, its rim amber and all else darkened. @param inside in widget pixels
    void drawKept(QPainter& painter, const QPainterPath& inside) const;
    void drawHandle(QPainter& painter, const Eigen::Vector2d& place) const;

signals:
    void strokeDrawn(const esm::PhotoStroke& stroke);
    void placePicked(const Eigen::Vector2d& place);
    void linesChanged();
    /// Frame or field while it is drawn; shapeFinished() when it is let go.
    void cropDrawn(const esm::PhotoCrop& crop);
    void fieldDrawn(const esm::PhotoField& field);
    void shapeFinished();
    /// Esc while it is drawn: how it was before.
    void cropDropped(const std::optional<esm::PhotoCrop>& before);
    void fieldDropped(const std::optional<esm::PhotoField>& before);

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
    double fittingScale() const;
    void fit();
    void place(double scale, const QPointF& origin);
    void redraw();
    QPainterPath rimOf(const PhotoField& field) const; ///< widget pixels
    bool toolTakes(const QKeyEvent& event);

    QImage m_picture, m_marked;
    QPixmap m_shown;  ///< the picture as the view has it
    QImage m_overlay; ///< what the strokes leave out, likewise
    std::vector<PhotoStroke> m_strokes;
    std::vector<DrawnLine> m_lines;
    std::optional<PhotoCrop> m_crop;
    std::optional<PhotoField> m_field;
    std::optional<QPointF> m_mouse, m_panned;
    PhotoTool m_kind = PhotoTool::LeaveOut;
    std::unique_ptr<CanvasTool> m_tool;
    PhotoBrush m_brush;
    FieldShape m_fieldShape = FieldShape::Ellipse;
    bool m_isCircle = true;
    double m_scale = 1;
    QPointF m_origin; ///< the photo's top left corner, widget pixels
    KeyPointer m_keyPointer{*this};
};

} // namespace esm
