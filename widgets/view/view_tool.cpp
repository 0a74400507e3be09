#include "widgets/view/view_tool.h"

#include <QCoreApplication>

namespace esm {

namespace {

QString translated(const char* text) {
    return QCoreApplication::translate("esm::ViewTool", text);
}

struct ToolWords {
    QString use;   ///< what only this tool does
    QString aside; ///< what else helps while it is in hand
};

ToolWords wordsOf(ViewTool tool) {
    switch (tool) {
    case ViewTool::Select:
        return {translated("Drag to turn the view · click picks"),
                translated("wheel zooms · Home shows all")};
    case ViewTool::Pull:
        return {translated("Drag to pull the tissue"), translated("Alt to turn the view · Esc lets go")};
    case ViewTool::Instrument:
        return {translated("Move to touch the surface · Ctrl and wheel push in and out"),
                translated("Esc takes it away")};
    case ViewTool::Region:
        return {translated(
                    "Drag the ellipsoid to move it · squares size it, dots turn it, the diamond widens its "
                    "soft rim"),
                translated("Alt to turn the view")};
    case ViewTool::Place:
        return {translated("Click the surface: the selected region lies there · with Ctrl a new one"),
                translated("drag to turn the view")};
    case ViewTool::Projector:
        return {
            translated("Drag the photo to place it · corners scale it, with Shift width and height apart"),
            translated("Alt to turn the view")};
    case ViewTool::Landmark:
        return {translated("Click a point in the photo, then the same point on the organ · drag a mark to "
                           "move it"),
                translated("drag elsewhere to turn the view")};
    case ViewTool::Brush:
        return {translated("Drag over the organ to paint · [ and ] make the brush smaller and larger"),
                translated("Alt to turn the view · Esc drops the stroke")};
    }
    return {};
}

} // namespace

QString toolUse(ViewTool tool) {
    return wordsOf(tool).use;
}

QString toolHint(ViewTool tool) {
    const ToolWords words = wordsOf(tool);
    return words.use + QStringLiteral(" · ") + words.aside;
}

} // namespace esm
