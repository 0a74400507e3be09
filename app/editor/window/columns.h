#pragma once

#include "app/editor/edits/preparation_edits.h"
#include "app/editor/panels/measure/measure_column.h"
#include "app/editor/tools/landmarking.h"
#include "app/editor/window/tool_controller.h"
#include "app/editor/window/workspaces.h"

namespace esm {

/// What the panels beside the view work on.
struct ColumnContext {
    Document& document;
    Selection& selection;
    PreparationEdits& preparations;
    Preview& preview;
    Landmarking& landmarking;
    MeasureColumn& measure;
    ToolController& tools;
    const Actions& actions;
    std::function<void()> showLargePhoto;
};

/// The columns of every workspace, with their panels.
void addColumns(Workspaces& workspaces, const ColumnContext& context);

} // namespace esm
