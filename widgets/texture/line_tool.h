#pragma once

#include "widgets/texture/canvas_tool.h"

namespace esm {

/// Draws lines along what should be straight, place by place. They stay with the canvas.
class LineTool : public CanvasTool {
public:
    explicit LineTool(PhotoCanvas& canvas) : CanvasTool(canvas) {}
    ~LineTool() override; ///< takes what was not ended along

    void press(const QMouseEvent& event) override;
    bool finish() override;
    bool takeBack() override;
    void paint(QPainter& painter) const override;
};

} // namespace esm
