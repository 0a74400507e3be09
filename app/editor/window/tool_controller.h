#pragma once

#include "app/editor/tools/tool_table.h"
#include "app/editor/window/actions.h"
#include "widgets/view/organ_view.h"

namespace esm {

/// The tools of the table: which is in hand, which can be taken, and why not.
class ToolController : public QObject {
    Q_OBJECT

public:
    ToolController(OrganView& view, const ToolContext& context);

    void connectActions(const Actions& actions);
    /// The options that stand there in a workspace, each seen while its tool is in hand.
    std::vector<QWidget*> makeOptions(ToolOptions place, ToolWorkspace workspace = ToolWorkspace::Any);

signals:
    /// Something for the line at the bottom.
    void message(const QString& text);

private:
    /// A tool that was made; actions hold the same order.
    struct Tool {
        ToolRow row;
        ViewTool* tool;
    };

    QString whyNot(const Tool& tool) const;
    void updateTools();
    void makeRoom();
    void updateHint();

    OrganView& m_view;
    Document& m_document;
    Selection& m_selection;
    Actions m_actions;
    std::vector<Tool> m_tools;
    bool m_hidLeft = false; ///< the left panels, for a tool that shows something beside the view
};

} // namespace esm
