#pragma once

#include "core/texture/photo/photo_preparation.h"
#include "widgets/texture/canvas_tool.h"

#include <optional>

namespace esm {

/// Frames the part of a photo that is kept, anew or by one of its corners.
class CropTool : public CanvasTool {
public:
    using CanvasTool::CanvasTool;
    void press(const QMouseEvent& event) override;
    void drag(const QMouseEvent& event) override;
    void release() override;
    bool drop() override;
    void paint(QPainter& painter) const override;

private:
    std::optional<Eigen::Vector2d> m_fixed; ///< corner opposite to the one that is dragged
    std::optional<PhotoCrop> m_before;      ///< that drag
};

} // namespace esm
