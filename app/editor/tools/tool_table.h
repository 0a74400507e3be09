#pragma once

#include "app/editor/tools/tool_context.h"
#include "widgets/view/view_tool.h"

#include <QKeySequence>

#include <vector>

namespace esm {

/// Where a tool can be taken.
enum class ToolWorkspace { Any, Tissue, Texture, Measure };

/// Where a tool's options stand.
enum class ToolOptions {
    None,
    Bar,    ///< in the bar on top
    Column, ///< first in the right column of the tool's workspaces
    Beside  ///< beside the view, which gives half of its room
};

/// All that the window knows of a tool.
struct ToolRow {
    QString name; ///< by which others ask for it
    QString icon;
    QString text; ///< in the menu
    QKeySequence key;
    QString does;  ///< its tool tip
    QString use;   ///< what only this tool does, in one line
    QString aside; ///< what else helps while it is in hand
    ToolWorkspace workspace;
    ToolOptions options;
    ViewTool* (*make)(const ToolContext&);
};

/// The editor's tools in the order of menu and strip, those of every workspace first. Actions, strip, keys,
/// help, hints and options are made from it.
std::vector<ToolRow> toolTable();

} // namespace esm
