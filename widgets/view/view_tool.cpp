#include "widgets/view/view_tool.h"

#include <QCoreApplication>

namespace esm {

QString toolHint(ViewTool tool) {
    const auto text = [](const char* hint) { return QCoreApplication::translate("esm::ViewTool", hint); };
    switch (tool) {
    case ViewTool::Select:
        return text("Drag to turn the view · wheel zooms · click picks · Home shows all");
    case ViewTool::Pull:
        return text("Drag to pull the tissue · Alt to turn the view · Esc lets go");
    case ViewTool::Instrument:
        return text("Move to touch the surface · Ctrl and wheel push in and out · Esc takes it away");
    case ViewTool::Region:
        return text("Drag the ellipsoid to move it · handles scale it · Alt to turn the view");
    case ViewTool::Projector:
        return text("Drag the photo to place it · handles scale width and height · Alt to turn the view");
    }
    return {};
}

} // namespace esm
