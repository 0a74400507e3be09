#pragma once

#include "core/texture/photo/photo_field.h"
#include "widgets/texture/canvas_tool.h"

#include <optional>
#include <vector>

namespace esm {

/// Sets the field of an endoscope, or mends one: its middle moves it, handles on its rim size it, the one
/// beyond turns an ellipse. Corners of a polygon are dragged, and new ones pulled out of a side. Where there
/// is no field a drag draws one: a circle or an ellipse from its middle, a polygon along the mouse's way.
class FieldTool : public CanvasTool {
public:
    enum class Shape { Circle, Ellipse, Polygon };

    explicit FieldTool(PhotoCanvas& canvas) : CanvasTool(canvas) {}
    void setShape(Shape shape) { m_shape = shape; }

    void press(const QMouseEvent& event) override;
    void drag(const QMouseEvent& event) override;
    void release() override;
    bool takeBack() override;
    bool drop() override;
    void paint(QPainter& painter) const override;

private:
    enum class Part { Whole, FirstRadius, SecondRadius, Turn, Corner, New };

    void grasp(const QPointF& at);
    void graspPolygon(const QPointF& at);
    void graspEllipse(const QPointF& at);
    void shapeTo(PhotoField& field, const Eigen::Vector2d& to);
    PhotoField begun(const Eigen::Vector2d& to);
    std::vector<Eigen::Vector2d> handles() const;

    Shape m_shape = Shape::Circle;
    std::optional<Part> m_part; ///< that is dragged
    std::size_t m_corner = 0;   ///< of a polygon, grasped last
    Eigen::Vector2d m_start = Eigen::Vector2d::Zero();
    PhotoOutline m_way; ///< of the mouse, of a polygon that is drawn
    std::optional<PhotoField> m_before;
};

} // namespace esm
