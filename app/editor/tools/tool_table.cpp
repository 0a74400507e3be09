#include "app/editor/tools/tool_table.h"

#include "app/editor/tools/brush_tool.h"
#include "app/editor/tools/distance_tool.h"
#include "app/editor/tools/finger_tool.h"
#include "app/editor/tools/fix_tool.h"
#include "app/editor/tools/instrument_tool.h"
#include "app/editor/tools/landmark_tool.h"
#include "app/editor/tools/look_tool.h"
#include "app/editor/tools/place_tool.h"
#include "app/editor/tools/projector_tool.h"
#include "app/editor/tools/pull_tool.h"
#include "app/editor/tools/region_tool.h"

namespace esm {

namespace {

QString translated(const char* text) {
    return QObject::tr(text);
}

template<typename Tool> ViewTool* made(const ToolContext& context) {
    return new Tool(context);
}

} // namespace

std::vector<ToolRow> toolTable() {
    using Workspace = ToolWorkspace;
    using Options = ToolOptions;
    return {
        {"look", "look", translated("&Look"), Qt::Key_V, translated("Turn and shift the view"),
         translated("Drag to turn the view · click picks"), translated("wheel zooms · {frame} shows all"),
         Workspace::Any, Options::None, made<LookTool>},
        {"pull", "pull", translated("P&ull"), Qt::Key_P, translated("Grasp the tissue and pull"),
         translated("Drag to pull the tissue"), translated("the right button turns the view · Esc lets go"),
         Workspace::Any, Options::None, made<PullTool>},
        {"instrument", "instrument", translated("&Instrument"), Qt::Key_I,
         translated("Push the tissue with a ball or a shaft"),
         translated("Move to touch the surface · Ctrl and wheel push in and out"),
         translated("Ctrl, Shift and wheel tilt a shaft · Esc takes it away"), Workspace::Any, Options::Bar,
         made<InstrumentTool>},
        {"distance", "distance", translated("&Distance"), Qt::Key_G,
         translated("Measure between two points, and scale the organ to a true length"),
         translated("Drag between two points of the organ, or click both: their distance at rest"),
         translated("the right button turns the view · Esc drops the points"), Workspace::Any,
         Options::Column, made<DistanceTool>},
        {"region", "region", translated("Re&gion"), Qt::Key_E,
         translated("Move, size and turn the region's ellipsoid"),
         translated(
             "Drag the ellipsoid along the surface · squares size it, dots turn it, the diamond widens "
             "its soft rim"),
         translated("Ctrl to go straight across the picture · the right button turns the view"),
         Workspace::Tissue, Options::None, made<RegionTool>},
        {"place", "place", translated("Place &on surface"), Qt::Key_O,
         translated("Lay a region on the surface with a click"),
         translated("Click the surface: the selected region lies there · with Ctrl a new one"),
         translated("a drag turns the view"), Workspace::Tissue, Options::None, made<PlaceTool>},
        {"fix", "fix", translated("Fi&x nodes"), Qt::Key_K, translated("Hold nodes in space, or let them go"),
         translated("Drag over the organ to fix nodes, with Ctrl to free them"),
         translated("[ and ] size the brush · the right button turns the view"), Workspace::Tissue,
         Options::Column, made<FixTool>},
        {"projector", "photo", translated("P&hoto"), Qt::Key_J,
         translated("Move, size, turn, roll and push the photo's projector"),
         translated("Drag the photo or its handles to place it"),
         translated("Ctrl and wheel push it · the right button turns the view"), Workspace::Texture,
         Options::None, made<ProjectorTool>},
        {"landmarks", "landmark", translated("Land&marks"), Qt::Key_M,
         translated("Place the photo by points that it shares with the organ"),
         translated("Click a point in the photo, then the same point on the organ · drag a mark to move it"),
         translated("a drag elsewhere turns the view"), Workspace::Texture, Options::Beside,
         made<LandmarkTool>},
        {"brush", "brush", translated("&Brush"), Qt::Key_D,
         translated("Erase and restore the photo, or paint on the organ"),
         translated("Drag over the organ to paint · [ and ] make the brush smaller and larger"),
         translated("the right button turns the view · Esc drops the stroke"), Workspace::Texture,
         Options::Column, made<BrushTool>},
        {"finger", "finger", translated("&Finger"), Qt::Key_Q,
         translated("Choose where the virtual test presses the organ"),
         translated("Click the organ: there the finger of the virtual test presses"),
         translated("a drag turns the view"), Workspace::Measure, Options::None, made<FingerTool>},
    };
}

} // namespace esm
