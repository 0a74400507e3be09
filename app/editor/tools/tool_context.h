#pragma once

#include "app/editor/document/document.h"
#include "app/editor/document/selection.h"
#include "app/editor/tools/landmarking.h"
#include "app/editor/workers/preview.h"
#include "app/editor/workers/virtual_test.h"

class QAction;

namespace esm {

/// What the editor's tools work on, shared with the rest of the window.
struct ToolContext {
    Document& document;
    Selection& selection;
    Preview& preview;
    Landmarking& landmarking;
    VirtualTest& virtualTest;
    const QAction& showRegions;   ///< checked while the regions' ellipsoids are drawn
    const QAction& showProjector; ///< the same of the selected photo's projector
};

/// What a tool that moves tissue says while none moves; empty while it does.
QString stillnessHint(const Preview& preview);
/// "0.35 N · 12.4 mm".
QString feltText(const FeltTissue& felt);
/// Why nothing can be done to the selected layer, or to its photo; empty where it can.
QString missingLayer(const Selection& selection);
QString missingPhoto(const Selection& selection);

} // namespace esm
