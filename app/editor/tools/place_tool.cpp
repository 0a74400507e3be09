#include "app/editor/tools/place_tool.h"

#include "app/editor/edits/starting_system.h"
#include "core/authoring/regions.h"

#include <QAction>

namespace esm {

PlaceTool::PlaceTool(const ToolContext& context)
    : m_document(context.document), m_selection(context.selection), m_showRegions(context.showRegions) {}

void PlaceTool::click(const ToolMouse& mouse) {
    const auto picked = mouse.picked();
    if (!picked) return;
    const bool isNew = mouse.keys.testFlag(Qt::ControlModifier);
    const RegionId added = m_document.newRegionId();
    const RegionId placed = isNew ? added : m_selection.region().value_or(added);
    m_document.edit(tr("Place region"), [&](Project& project) {
        placeRegion(project, placed, added, picked->spot, startingSystem());
    });
    emit done(QStringLiteral("region"));
}

QString PlaceTool::whyNot() const {
    return m_showRegions.isChecked() ? QString() : tr("The regions are hidden: H shows them");
}

} // namespace esm
