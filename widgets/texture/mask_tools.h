#pragma once

#include "core/texture/photo/photo_mask.h"
#include "widgets/texture/canvas_tool.h"

#include <optional>

namespace esm {

/// Draws a stroke that leaves something out; or takes it back, always or while Ctrl is held.
class MaskTool : public CanvasTool {
public:
    using CanvasTool::CanvasTool;
    void release() override;
    bool drop() override;
    void paint(QPainter& painter) const override;

protected:
    std::optional<PhotoStroke> m_stroke; ///< at work
};

class MaskBrush : public MaskTool {
public:
    MaskBrush(PhotoCanvas& canvas, bool takesBack) : MaskTool(canvas), m_takesBack(takesBack) {}
    void press(const QMouseEvent& event) override;
    void drag(const QMouseEvent& event) override;
    void paintCursor(QPainter& painter, const QPointF& mouse) const override;

private:
    bool m_takesBack;
};

/// A line around something, whose inside is left out.
class MaskOutline : public MaskTool {
public:
    using MaskTool::MaskTool;
    void press(const QMouseEvent& event) override;
    void drag(const QMouseEvent& event) override;
    void release() override;
};

class MaskBox : public MaskTool {
public:
    using MaskTool::MaskTool;
    void press(const QMouseEvent& event) override;
    void drag(const QMouseEvent& event) override;
    void release() override;
};

/// Says which place was clicked.
class PlacePicker : public CanvasTool {
public:
    using CanvasTool::CanvasTool;
    void press(const QMouseEvent& event) override;
};

} // namespace esm
