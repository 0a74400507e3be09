#pragma once

#include "app/editor/tools/tool_context.h"
#include "widgets/view/dragging.h"
#include "widgets/view/projector_handles.h"
#include "widgets/view/view_tool.h"

#include <variant>

class QAction;

namespace esm {

/// Moves a photo's projector, and sizes, turns, rolls and pushes it by its handles.
class ProjectorTool : public ViewTool {
    Q_OBJECT

public:
    explicit ProjectorTool(const ToolContext& context);

    Hold press(const ToolMouse& mouse) override;
    bool takesShift(const ToolMouse& mouse) const override;
    void move(const ToolMouse& mouse) override;
    std::vector<QPointF> stops(const Sight& sight) const override;
    void release() override;
    /// Puts back what is dragged.
    void cancel() override;
    void leave() override;
    /// With Ctrl it pushes the projector along its line of sight.
    bool wheel(const ToolMouse& mouse, double notches) override;
    void draw(QPainter& painter, const Sight& sight, const QPalette& palette) const override;
    bool showsProjector() const override { return true; }
    Qt::CursorShape cursor() const override;
    QString hint() const override;
    QString whyNot() const override { return missingPhoto(m_selection); }

private:
    /// What the mouse is over or holds.
    struct Held {
        std::optional<ProjectorHandle> handle; ///< none: the photo itself, which is moved
        double slant = 0;                      ///< degrees, how the handle lies from the photo's middle
    };
    struct Drag {
        LayerId photo;
        PhotoFace start;
        Held held;
        Eigen::Vector3d target; ///< m, what the projector looked at
        DragPlane plane;        ///< in which the photo is moved
        QPointF place;          ///< pixels, of the mouse
        Ray ray;                ///< through it
    };

    std::optional<Held> heldAt(const ToolMouse& mouse) const;
    Projector dragged(const Drag& drag, const ToolMouse& mouse) const;
    Projector turnedBy(const Drag& drag, const ToolMouse& mouse) const;
    void endPushing();
    void lookAt(const std::optional<Held>& held);
    void place(LayerId photo, const Projector& projector);

    Document& m_document;
    Selection& m_selection;
    const QAction& m_showProjector;
    std::optional<Drag> m_drag;
    std::optional<Held> m_under; ///< the mouse, while nothing is dragged
    bool m_isPushing = false;    ///< by the wheel
};

} // namespace esm
