#include "app/editor/window/tool_controller.h"

#include "app/editor/window/shortcuts.h"

#include <QDockWidget>
#include <QLayout>
#include <QScrollArea>

#include <algorithm>
#include <utility>

namespace esm {

namespace {

/// In front of the panels that lie in the same place, and scrolled to.
void bringIntoSight(QWidget& options) {
    for (QWidget* around = options.parentWidget(); around; around = around->parentWidget()) {
        if (auto* dock = qobject_cast<QDockWidget*>(around)) dock->raise();
        auto* column = qobject_cast<QScrollArea*>(around);
        if (!column) continue;
        column->widget()->layout()->activate();
        column->ensureWidgetVisible(&options);
    }
}

} // namespace

ToolController::ToolController(OrganView& view, const ToolContext& context)
    : QObject(&view), m_view(view), m_document(context.document), m_selection(context.selection),
      m_actions() {
    for (const ToolRow& row : toolTable()) {
        ViewTool* tool = row.make(context);
        tool->setParent(this);
        tool->setObjectName(row.name);
        connect(tool, &ViewTool::message, this, &ToolController::message);
        connect(tool, &ViewTool::changed, this, [this, tool] {
            if (&m_view.tool() == tool) updateHint();
        });
        m_tools.push_back({row, tool});
    }
}

void ToolController::connectActions(const Actions& actions) {
    m_actions = actions;
    for (const auto& [row, tool] : m_tools) {
        QAction* action = actions.tool(row.name);
        connect(action, &QAction::triggered, this, [this, tool = tool] { m_view.setTool(*tool); });
        connect(&m_view, &OrganView::toolChanged, action, [this, action, tool = tool] {
            if (&m_view.tool() == tool) action->setChecked(true);
        });
        connect(tool, &ViewTool::done, this,
                [this](const QString& next) { m_actions.tool(next)->trigger(); });
    }
    actions.tool(QStringLiteral("pull"))->trigger();
    connect(actions.letGo, &QAction::triggered, &m_view, &OrganView::cancel);
    for (const QAction* workspace : {actions.texture, actions.measure})
        connect(workspace, &QAction::toggled, this, &ToolController::updateTools);
    connect(actions.showRegions, &QAction::toggled, this, &ToolController::updateTools);
    for (const QAction* shown : {actions.showProjector, actions.showBare})
        connect(shown, &QAction::toggled, this, &ToolController::updateHint);
    connect(&m_document, &Document::changed, this, &ToolController::updateTools);
    connect(&m_selection, &Selection::changed, this, &ToolController::updateTools);
    connect(&m_view, &OrganView::toolChanged, this, &ToolController::updateHint);
    connect(&m_view, &OrganView::toolChanged, this, &ToolController::makeRoom);
    connect(actions.addPhoto, &QAction::changed, this, &ToolController::updateHint);
    // Where their keys are said, others may have been chosen.
    for (const QAction* said : {actions.tissue, actions.texture, actions.measure, actions.addRegion,
                                actions.showRegions, actions.showProjector, actions.showBare, actions.frame})
        connect(said, &QAction::changed, this, &ToolController::updateTools);
    updateTools();
}

std::vector<QWidget*> ToolController::makeOptions(ToolOptions place, ToolWorkspace workspace) {
    std::vector<QWidget*> made;
    for (const auto& [row, tool] : m_tools) {
        const bool isThere = workspace == ToolWorkspace::Any || row.workspace == ToolWorkspace::Any ||
                             row.workspace == workspace;
        if (row.options != place || !isThere) continue;
        QWidget* options = tool->makeOptions();
        options->setVisible(&m_view.tool() == tool);
        connect(&m_view, &OrganView::toolChanged, options, [this, options, tool = tool] {
            options->setVisible(&m_view.tool() == tool);
            if (&m_view.tool() == tool) bringIntoSight(*options);
        });
        made.push_back(options);
    }
    return made;
}

/// What stands beside the view takes the place of the left panels, and gives it back with the tool. Who shows
/// the panels all the same keeps them.
void ToolController::makeRoom() {
    QAction& left = *m_actions.showLeft;
    const bool needsRoom = std::any_of(m_tools.begin(), m_tools.end(), [this](const Tool& tool) {
        return tool.tool == &m_view.tool() && tool.row.options == ToolOptions::Beside;
    });
    if (needsRoom && left.isChecked()) {
        m_hidLeft = true;
        left.setChecked(false);
        m_view.setFocus(); // or the next field would get it, and the tools' keys be typed into it
    } else if (!needsRoom && std::exchange(m_hidLeft, false)) {
        left.setChecked(true);
    }
}

QString ToolController::whyNot(const Tool& tool) const {
    const bool texture = m_actions.texture->isChecked();
    if (tool.row.workspace == ToolWorkspace::Measure)
        return m_actions.measure->isChecked() ? tool.tool->whyNot()
                                              : tr("This tool belongs to the workspace Measure ({measure})");
    if (texture && tool.row.workspace == ToolWorkspace::Tissue)
        return tr("This tool belongs to the workspace Tissue ({tissue})");
    if (!texture && tool.row.workspace == ToolWorkspace::Texture)
        return tr("This tool belongs to the workspace Texture ({texture})");
    return tool.tool->whyNot();
}

void ToolController::updateTools() {
    for (const Tool& tool : m_tools) {
        const QString reason = whyNot(tool);
        QAction* action = m_actions.tool(tool.row.name);
        enable(action, reason.isEmpty(), tool.row.does, withKeys(reason, m_actions));
        if (!reason.isEmpty() && &m_view.tool() == tool.tool) m_view.setTool(*m_tools.front().tool);
    }
    updateHint();
}

void ToolController::updateHint() {
    if (m_actions.showBare->isChecked())
        return m_view.setHint(withKeys(
            tr("Before: the organ without photos and paint · {showBare} shows them again"), m_actions));
    if (m_actions.texture->isChecked() && m_document.project().layers.empty())
        return m_view.setHint(
            m_actions.addPhoto->isEnabled()
                ? withKeys(tr("No photo yet: {addPhoto} adds one, or drop a picture on the organ"), m_actions)
                : m_actions.addPhoto->toolTip());
    for (const auto& [row, tool] : m_tools) {
        if (&m_view.tool() != tool) continue;
        const QString now = tool->hint();
        m_view.setHint(
            withKeys(now.isEmpty() ? row.use + QStringLiteral(" · ") + row.aside : now, m_actions));
    }
}

} // namespace esm
