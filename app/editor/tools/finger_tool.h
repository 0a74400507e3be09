#pragma once

#include "app/editor/tools/tool_context.h"
#include "widgets/view/view_tool.h"

namespace esm {

/// Turns the view; a click chooses where the virtual test's finger presses, which stands there as a ball.
class FingerTool : public ViewTool {
    Q_OBJECT

public:
    explicit FingerTool(const ToolContext& context);

    void click(const ToolMouse& mouse) override;
    void draw(QPainter& painter, const Sight& sight, const QPalette& palette) const override;
    Qt::CursorShape cursor() const override { return Qt::CrossCursor; }
    QString hint() const override;

private:
    VirtualTest& m_test;
};

} // namespace esm
