#pragma once

#include "app/editor/tools/tool_context.h"
#include "core/authoring/scale.h"
#include "widgets/view/view_tool.h"

#include <QTimer>

namespace esm {

/// Measures between two points of the surface, and scales the organ to a true length. The length is that of
/// the organ at rest, also while it moves: the points go where the surface carries them. They are no part of
/// the project.
class DistanceTool : public ViewTool {
    Q_OBJECT

public:
    explicit DistanceTool(const ToolContext& context);

    /// Between both points at rest, m; none while there are not two.
    std::optional<double> length() const;
    std::optional<double> trueLength() const { return m_trueLength; } ///< m
    void setTrueLength(double metres);
    KeptByScaling kept() const { return m_kept; }
    void setKept(KeptByScaling kept);
    /// Why the organ cannot be scaled now; empty where it can.
    const QString& obstacle() const { return m_obstacle; }
    /// Whether it is yet to be said anew, once edits rest.
    bool isObstacleOld() const { return m_rest.isActive(); }
    /// Scales the organ by one undoable edit, where nothing is in the way.
    void scaleOrgan();

    Hold press(const ToolMouse& mouse) override;
    void move(const ToolMouse& mouse) override;
    void release() override;
    void click(const ToolMouse& mouse) override;
    void cancel() override;
    void draw(QPainter& painter, const Sight& sight, const QPalette& palette) const override;
    Qt::CursorShape cursor() const override;
    QString hint() const override;
    QWidget* makeOptions() override;

private:
    void followDocument(const Change& change);
    Eigen::Vector3d restPoint(const CarriedPlace& place) const;
    std::optional<std::size_t> pointAt(const ToolMouse& mouse) const;
    void update();
    QString findObstacle() const;

    Document& m_document;
    std::vector<CarriedPlace> m_points;             ///< two at most
    std::shared_ptr<const TriangleMesh> m_surface;  ///< that they lie on
    std::shared_ptr<const SpringNetwork> m_network; ///< or its nodes
    std::optional<std::size_t> m_held;              ///< the point that is moved
    std::optional<CarriedPlace> m_begun;            ///< where a drag began that is to lay both points
    bool m_isOverPoint = false;
    std::optional<double> m_trueLength; ///< m
    KeptByScaling m_kept = KeptByScaling::Mass;
    QString m_obstacle;
    QTimer m_rest; ///< until the obstacle is found anew
};

} // namespace esm
