#include "widgets/view/view_tool.h"

#include <QCoreApplication>

namespace esm {

namespace {

QString translated(const char* text) {
    return QCoreApplication::translate("esm::ViewTool", text);
}

QString toolHelp(ViewTool tool) {
    switch (tool) {
    case ViewTool::Select:
        return translated("wheel zooms · Home shows all");
    case ViewTool::Pull:
        return translated("Alt to turn the view · Esc lets go");
    case ViewTool::Instrument:
        return translated("Esc takes it away");
    case ViewTool::Region:
    case ViewTool::Projector:
        return translated("Alt to turn the view");
    }
    return {};
}

} // namespace

QString toolUse(ViewTool tool) {
    switch (tool) {
    case ViewTool::Select:
        return translated("Drag to turn the view · click picks");
    case ViewTool::Pull:
        return translated("Drag to pull the tissue");
    case ViewTool::Instrument:
        return translated("Move to touch the surface · Ctrl and wheel push in and out");
    case ViewTool::Region:
        return translated("Drag the ellipsoid to move it · handles scale it");
    case ViewTool::Projector:
        return translated("Drag the photo to place it · corners scale it, with Shift width and height apart");
    }
    return {};
}

QString toolHint(ViewTool tool) {
    return toolUse(tool) + QStringLiteral(" · ") + toolHelp(tool);
}

} // namespace esm
