#pragma once

#include "app/editor/tools/region_picking.h"
#include "app/editor/tools/tool_context.h"

namespace esm {

/// Turns the view; a click selects a region.
class LookTool : public ViewTool {
    Q_OBJECT

public:
    explicit LookTool(const ToolContext& context)
        : m_document(context.document), m_selection(context.selection) {}

    void click(const ToolMouse& mouse) override { selectRegionUnder(mouse, m_document, m_selection); }

private:
    Document& m_document;
    Selection& m_selection;
};

} // namespace esm
