#pragma once

#include "app/editor/tools/tool_context.h"
#include "widgets/view/gizmos.h"
#include "widgets/view/view_tool.h"

namespace esm {

/// Moves the round instrument over the surface, or at its depth once it is pushed in.
class InstrumentTool : public ViewTool {
    Q_OBJECT

public:
    explicit InstrumentTool(const ToolContext& context);

    double radius() const { return m_radius; } ///< m
    /// The user's own size, kept for every organ from now on.
    void chooseRadius(double metres);

    Hold press(const ToolMouse& mouse) override;
    void move(const ToolMouse& mouse) override;
    void release() override { m_sweep.reset(); }
    void cancel() override;
    void leave() override;
    bool wheel(const ToolMouse& mouse, double notches) override;
    void dress(RenderScene& scene) const override;
    QString hint() const override { return stillnessHint(m_preview); }
    QWidget* makeOptions() override;

signals:
    void radiusChanged(double metres);

private:
    void followDocument(const Change& change);
    void setRadius(double metres);
    void hover(const ToolMouse& mouse);
    void show();

    Document& m_document;
    Preview& m_preview;
    double m_radius = 0.01;                  ///< m
    bool m_isChosen = false;                 ///< the radius, by the user
    std::optional<Eigen::Vector3d> m_centre; ///< m
    bool m_isPushed = false;                 ///< moves at its depth instead of along the surface
    std::optional<DragPlane> m_sweep;        ///< while the button is down
};

} // namespace esm
