#pragma once

#include "app/editor/tools/tool_context.h"
#include "widgets/view/dragging.h"
#include "widgets/view/view_tool.h"

#include <variant>

namespace esm {

/// Moves a photo's projector and sizes it by its handles.
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
    void draw(QPainter& painter, const Sight& sight, const QPalette& palette) const override;
    bool showsProjector() const override { return true; }
    QString hint() const override;
    QString whyNot() const override { return missingPhoto(m_selection); }

private:
    void place(LayerId photo, const Projector& projector);

    struct Drag {
        LayerId photo;
        PhotoFace start;
        std::variant<std::size_t, DragPlane> held; ///< a handle, or the photo's plane, in which it is moved
    };

    Document& m_document;
    Selection& m_selection;
    const QAction& m_showProjector;
    std::optional<Drag> m_drag;
};

} // namespace esm
