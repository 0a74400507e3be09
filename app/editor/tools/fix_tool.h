#pragma once

#include "app/editor/tools/brush_path.h"
#include "app/editor/tools/tool_context.h"
#include "widgets/view/view_tool.h"

namespace esm {

/// Holds the nodes in space that it is led over; with Ctrl it lets them go. On a model of nodes alone it
/// takes the node under the mouse.
class FixTool : public ViewTool {
    Q_OBJECT

public:
    explicit FixTool(const ToolContext& context);

    double radius() const { return m_radius; } ///< m
    /// No larger than the organ: see largestRadius().
    void setRadius(double metres);
    double largestRadius() const; ///< m, half of the organ's diagonal

    Hold press(const ToolMouse& mouse) override;
    void move(const ToolMouse& mouse) override;
    void release() override;
    /// Puts back what the stroke fixed or freed.
    void cancel() override;
    void leave() override;
    void draw(QPainter& painter, const Sight& sight, const QPalette& palette) const override;
    Qt::CursorShape cursor() const override { return Qt::CrossCursor; }
    QWidget* makeOptions() override;

private:
    enum class Does { Fix, Free };
    struct Stroke {
        Does does;
        std::vector<NodeSelection> before; ///< that were fixed
        MouseWay way;
    };

    void followDocument(const Change& change);
    void lookAt(const ToolMouse& mouse);
    std::vector<std::uint32_t> nodesTo(const ToolMouse& mouse) const;
    void edit(const std::function<void(Project&)>& change);

    Document& m_document;
    double m_radius = 0.01; ///< m
    std::optional<PickedPoint> m_at;
    std::optional<Stroke> m_stroke;
};

} // namespace esm
