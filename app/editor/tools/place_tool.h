#pragma once

#include "app/editor/tools/tool_context.h"
#include "widgets/view/view_tool.h"

namespace esm {

/// Turns the view; a click lays the selected region on the surface, with Ctrl a new one. To shape it comes
/// next.
class PlaceTool : public ViewTool {
    Q_OBJECT

public:
    explicit PlaceTool(const ToolContext& context);

    void click(const ToolMouse& mouse) override;
    Qt::CursorShape cursor() const override { return Qt::CrossCursor; }
    QString whyNot() const override;

private:
    Document& m_document;
    Selection& m_selection;
    const QAction& m_showRegions;
};

} // namespace esm
