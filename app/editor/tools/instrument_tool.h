#pragma once

#include "app/editor/tools/tool_context.h"
#include "widgets/view/gizmos.h"
#include "widgets/view/view_tool.h"

namespace esm {

/// What the mouse holds.
enum class InstrumentKind { Ball, Shaft };

/// Moves an instrument over the surface, or at its depth once it is pushed in: a ball, or a shaft whose tip
/// is under the mouse and which is held from the lower right.
class InstrumentTool : public ViewTool {
    Q_OBJECT

public:
    explicit InstrumentTool(const ToolContext& context);

    const Collider& shape() const { return m_shape; }
    /// Of a size that fits the organ, until the user chooses one.
    void chooseKind(InstrumentKind kind);
    /// The user's own size, kept for every organ from now on.
    void chooseRadius(double metres);
    void chooseLength(double metres); ///< Precondition: the shape is a capsule

    Hold press(const ToolMouse& mouse) override;
    void move(const ToolMouse& mouse) override;
    void release() override { m_sweep.reset(); }
    void cancel() override;
    void leave() override;
    bool wheel(const ToolMouse& mouse, double notches) override;
    void dress(RenderScene& scene) const override;
    void draw(QPainter& painter, const Sight& sight, const QPalette& palette) const override;
    QString hint() const override { return stillnessHint(m_preview); }
    QWidget* makeOptions() override;

signals:
    void shapeChanged();

private:
    void followDocument(const Change& change);
    void setShape(const Collider& shape);
    void lead(const ToolMouse& mouse, const std::optional<Eigen::Vector3d>& tip);
    void hover(const ToolMouse& mouse);
    void show();
    PlacedCollider placed() const;
    PlacedCollider shown() const;

    Document& m_document;
    Preview& m_preview;
    Collider m_shape = Sphere{0.01};
    bool m_isChosen = false; ///< the size, by the user
    std::optional<Eigen::Vector3d>
        m_tip; ///< m, the centre of what touches: the ball, or the shaft's round end
    Eigen::Vector3d m_towardsHand{0, 0, 1}; ///< of length 1, from the tip along the shaft
    double m_tilt;                          ///< radians, between the shaft and the line of sight
    bool m_isPushed = false;                ///< moves at its depth instead of along the surface
    std::optional<DragPlane> m_sweep;       ///< while the button is down
};

} // namespace esm
