#pragma once

#include "app/editor/tools/tool_context.h"
#include "widgets/view/marks.h"
#include "widgets/view/photo_view.h"
#include "widgets/view/view_tool.h"

#include <QPointer>

namespace esm {

/// Turns the view; clicks say where points of the photo, which stands above, lie on the organ. Marks are
/// dragged.
class LandmarkTool : public ViewTool {
    Q_OBJECT

public:
    explicit LandmarkTool(const ToolContext& context);

    Hold press(const ToolMouse& mouse) override;
    void move(const ToolMouse& mouse) override;
    void release() override;
    void click(const ToolMouse& mouse) override;
    void cancel() override;
    void draw(QPainter& painter, const Sight& sight, const QPalette& palette) const override;
    Qt::CursorShape cursor() const override { return Qt::CrossCursor; }
    /// Why the landmarks give no camera, where they do not.
    QString hint() const override { return m_landmarking.failure(); }
    QString whyNot() const override { return missingPhoto(m_selection); }
    QWidget* makeOptions() override;

private:
    /// A landmark on the organ at rest.
    struct OrganMark {
        Eigen::Vector3d point; ///< m
        MarkLook look;
    };

    void show();
    std::vector<PaintedMark> painted(const Sight& sight) const;

    Selection& m_selection;
    Landmarking& m_landmarking;
    QPointer<PhotoView> m_photo;
    std::vector<OrganMark> m_marks;
    std::optional<int> m_dragged; ///< a mark's number
};

} // namespace esm
