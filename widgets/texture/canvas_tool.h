#pragma once

#include <QMouseEvent>
#include <QPainter>

namespace esm {

class PhotoCanvas;

/// What the mouse does on a photo: it owns what is being drawn, and tells it by the canvas's signals.
class CanvasTool {
public:
    explicit CanvasTool(PhotoCanvas& canvas) : m_canvas(canvas) {}
    virtual ~CanvasTool() = default;
    CanvasTool(const CanvasTool&) = delete;
    CanvasTool& operator=(const CanvasTool&) = delete;

    /// The left button, in widget pixels.
    virtual void press(const QMouseEvent& event) = 0;
    virtual void drag(const QMouseEvent&) {}
    virtual void release() {}
    /// A double click, the right button or Enter; false where it has nothing to end.
    virtual bool finish() { return false; }
    /// Backspace: takes the last place back; false where there is none.
    virtual bool takeBack() { return false; }
    /// Esc: drops what is being drawn; false where nothing is.
    virtual bool drop() { return false; }
    virtual void paint(QPainter&) const {}
    /// @param mouse where it is, widget pixels
    virtual void paintCursor(QPainter&, const QPointF& /*mouse*/) const {}

protected:
    PhotoCanvas& m_canvas;
};

} // namespace esm
