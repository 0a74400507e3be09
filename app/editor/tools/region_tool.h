#pragma once

#include "app/editor/tools/tool_context.h"
#include "widgets/view/dragging.h"
#include "widgets/view/region_handles.h"
#include "widgets/view/view_tool.h"

#include <variant>

namespace esm {

/// Moves, sizes and turns a region's ellipsoid, and widens its rim. Moved, its middle follows the surface, as
/// far behind it in the line of sight as it was; with Ctrl it goes straight across the picture. A click
/// selects.
class RegionTool : public ViewTool {
    Q_OBJECT

public:
    explicit RegionTool(const ToolContext& context);

    Hold press(const ToolMouse& mouse) override;
    void move(const ToolMouse& mouse) override;
    void release() override;
    /// Puts back what is dragged.
    void cancel() override;
    void click(const ToolMouse& mouse) override;
    void draw(QPainter& painter, const Sight& sight, const QPalette& palette) const override;
    Qt::CursorShape cursor() const override;
    std::vector<QPointF> stops(const Sight& sight) const override;
    QString whyNot() const override;

private:
    /// Where the ellipsoid's middle is seen, and how far behind the surface there.
    struct OnSurface {
        QPointF fromMouse; ///< pixels
        double depth;      ///< m
    };
    struct Move {
        DragPlane plane;
        std::optional<OnSurface> onSurface; ///< none where no surface is seen there
    };
    struct Size {
        std::size_t end; ///< counts as in `handles`
    };
    struct Turn {
        Grip grip;
    };
    struct Rim {
        DragPlane plane;
        double start; ///< m
    };
    struct Drag {
        RegionId region;
        Ellipsoid start;
        std::variant<Move, Size, Turn, Rim> what;
    };

    static std::optional<OnSurface> onSurface(const ToolMouse& mouse, const Ellipsoid& shape);
    std::optional<Drag> dragAt(const ToolMouse& mouse) const;
    Ellipsoid moved(const Drag& drag, const ToolMouse& mouse) const;
    void follow(const Drag& drag, const ToolMouse& mouse);
    void shape(RegionId region, const Ellipsoid& shape);
    void widenRim(RegionId region, double metres);
    void followDocument(const Change& change);

    Document& m_document;
    Selection& m_selection;
    const QAction& m_showRegions;
    std::optional<Drag> m_drag;
    bool m_isOverHandle = false;
};

} // namespace esm
