#pragma once

#include "app/editor/tools/brush_path.h"
#include "app/editor/tools/painting.h"
#include "app/editor/tools/tool_context.h"
#include "widgets/view/view_tool.h"

namespace esm {

/// Paints on the surface; a click with Ctrl says where a brush that copies takes its colours.
class BrushTool : public ViewTool {
    Q_OBJECT

public:
    explicit BrushTool(const ToolContext& context);

    Hold press(const ToolMouse& mouse) override;
    void move(const ToolMouse& mouse) override;
    void release() override;
    void cancel() override;
    void leave() override;
    void draw(QPainter& painter, const Sight& sight, const QPalette& palette) const override;
    Qt::CursorShape cursor() const override { return Qt::CrossCursor; }
    QString whyNot() const override { return missingLayer(m_selection); }
    QString hint() const override;
    QWidget* makeOptions() override;

private:
    /// Of the brush, while it is down.
    struct Down {
        MouseWay way;
        std::optional<double> pressure; ///< of a pen as it was last
        bool hasBegun;                  ///< it has been on the surface
    };

    void lookAt(const std::optional<PickedPoint>& point);
    void goOn(const std::vector<std::optional<BrushTouch>>& touches);

    Selection& m_selection;
    Painting m_painting;
    std::optional<PickedPoint> m_at; ///< under the mouse, as it was last moved
    std::optional<Down> m_down;
};

} // namespace esm
