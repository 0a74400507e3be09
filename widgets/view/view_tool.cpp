#include "widgets/view/view_tool.h"

#include <QCoreApplication>

namespace esm {

QString toolHint(ViewTool tool) {
    switch (tool) {
    case ViewTool::Select:
        return QCoreApplication::translate(
            "esm::ViewTool", "Drag to turn the view · wheel zooms · click picks · Home shows all");
    case ViewTool::Pull:
        return QCoreApplication::translate("esm::ViewTool",
                                           "Drag to pull the tissue · Alt to turn the view · Esc lets go");
    case ViewTool::Instrument:
        return QCoreApplication::translate(
            "esm::ViewTool",
            "Move to touch the surface · Ctrl and wheel push in and out · Esc takes it away");
    case ViewTool::Region:
        return QCoreApplication::translate(
            "esm::ViewTool", "Drag the ellipsoid to move it · handles scale it · Alt to turn the view");
    case ViewTool::Projector:
        return QCoreApplication::translate(
            "esm::ViewTool",
            "Drag the photo to place it · handles scale width and height · Alt to turn the view");
    }
    return {};
}

} // namespace esm
