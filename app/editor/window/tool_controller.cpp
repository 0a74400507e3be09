#include "app/editor/window/tool_controller.h"

#include <algorithm>

namespace esm {

ToolController::ToolController(OrganView& view, Document& document, Selection& selection, Preview& preview)
    : QObject(&view), m_view(view), m_document(document), m_selection(selection), m_preview(preview),
      m_actions() {}

void ToolController::connectActions(const Actions& actions) {
    m_actions = actions;
    bind(actions.look, ViewTool::Select);
    bind(actions.pull, ViewTool::Pull);
    bind(actions.instrument, ViewTool::Instrument);
    bind(actions.region, ViewTool::Region);
    bind(actions.place, ViewTool::Place);
    bind(actions.projector, ViewTool::Projector);
    bind(actions.landmarks, ViewTool::Landmark);
    bind(actions.brush, ViewTool::Brush);
    m_view.setTool(ViewTool::Pull);
    connect(actions.letGo, &QAction::triggered, &m_view, &OrganView::letGo);
    connect(actions.texture, &QAction::toggled, this, &ToolController::updateTools);
    connect(actions.showRegions, &QAction::toggled, this, &ToolController::updateTools);
    connect(&m_document, &Document::changed, this, &ToolController::updateTools);
    connect(&m_selection, &Selection::changed, this, &ToolController::updateTools);
    connect(&m_preview, &Preview::statusChanged, this, &ToolController::updateHint);
    connect(&m_view, &OrganView::toolChanged, this, &ToolController::updateHint);
    connect(actions.addPhoto, &QAction::changed, this, &ToolController::updateHint);
    updateTools();
}

void ToolController::bind(QAction* action, ViewTool tool) {
    connect(action, &QAction::triggered, this, [this, tool] { m_view.setTool(tool); });
    connect(&m_view, &OrganView::toolChanged, action, [action, tool](ViewTool now) {
        if (now == tool) action->setChecked(true);
    });
}

void ToolController::updateTools() {
    const bool texture = m_actions.texture->isChecked();
    const auto& regions = m_document.project().regions;
    const bool none = std::none_of(regions.begin(), regions.end(),
                                   [](const Region& region) { return region.ellipsoid.has_value(); });
    const QString unseen = texture ? tr("Regions are shaped in the workspace Tissue (Ctrl+1)")
                           : !m_actions.showRegions->isChecked() ? tr("The regions are hidden: H shows them")
                                                                 : QString();
    allow(m_actions.region, ViewTool::Region,
          withShortcut(tr("Move, size and turn the region's ellipsoid"), m_actions.region),
          none && !texture ? tr("There is no region yet: Ctrl+R adds one") : unseen);
    allow(m_actions.place, ViewTool::Place,
          withShortcut(tr("Lay a region on the surface with a click"), m_actions.place), unseen);
    const auto layer = m_selection.photo();
    const bool isPainted = layer && !m_document.project().layers[*layer].photo;
    const QString noLayer = !texture ? tr("Photos are placed in the workspace Texture (Ctrl+2)")
                            : !layer ? tr("There is no photo yet: Ctrl+P adds one")
                                     : QString();
    const QString noPhoto =
        isPainted && texture ? tr("The selected layer has no photo, it is painted") : noLayer;
    allow(m_actions.projector, ViewTool::Projector,
          withShortcut(tr("Move and size the photo's projector"), m_actions.projector), noPhoto);
    allow(m_actions.landmarks, ViewTool::Landmark,
          withShortcut(tr("Place the photo by points that it shares with the organ"), m_actions.landmarks),
          noPhoto);
    allow(m_actions.brush, ViewTool::Brush,
          withShortcut(tr("Erase and restore the photo, or paint on the organ"), m_actions.brush), noLayer);
    updateHint();
}

void ToolController::allow(QAction* action, ViewTool tool, const QString& does, const QString& whyNot) {
    const bool allowed = whyNot.isEmpty();
    action->setEnabled(allowed);
    action->setToolTip(allowed ? does : whyNot);
    if (!allowed && m_view.tool() == tool) m_view.setTool(ViewTool::Select);
}

void ToolController::updateHint() {
    const bool moves = m_view.tool() == ViewTool::Pull || m_view.tool() == ViewTool::Instrument;
    const PreviewStatus status = m_preview.status();
    if (m_actions.texture->isChecked() && m_document.project().layers.empty())
        return m_view.setHint(m_actions.addPhoto->isEnabled()
                                  ? tr("No photo yet: Ctrl+P adds one, or drop a picture on the organ")
                                  : m_actions.addPhoto->toolTip());
    if (!moves || status.playing)
        m_view.setHint({});
    else if (status.failure.empty())
        m_view.setHint(tr("Paused: Space lets the tissue move again"));
    else
        m_view.setHint(tr("The tissue does not move: the line at the bottom says why"));
}

} // namespace esm
