#pragma once

#include "app/editor/tools/tool_context.h"
#include "widgets/view/gizmos.h"
#include "widgets/view/view_tool.h"

namespace esm {

/// Pulls the tissue: the node under the mouse follows it parallel to the picture.
class PullTool : public ViewTool {
    Q_OBJECT

public:
    explicit PullTool(const ToolContext& context);

    Hold press(const ToolMouse& mouse) override;
    void move(const ToolMouse& mouse) override;
    void release() override;
    /// What is felt, beside the node that is held.
    void draw(QPainter& painter, const Sight& sight, const QPalette& palette) const override;
    QString hint() const override { return stillnessHint(m_preview); }

private:
    struct Drag {
        std::uint32_t node;
        DragPlane plane;            ///< through the picked point, parallel to the picture
        Eigen::Vector3d nodeOffset; ///< from the picked point to the node, m
    };

    Preview& m_preview;
    std::optional<Drag> m_drag;
};

} // namespace esm
