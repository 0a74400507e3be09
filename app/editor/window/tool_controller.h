#pragma once

#include "app/editor/document/document.h"
#include "app/editor/document/selection.h"
#include "app/editor/window/actions.h"
#include "app/editor/workers/preview.h"
#include "widgets/view/organ_view.h"

namespace esm {

/// Which tool is in hand, which can be taken, and why not.
class ToolController : public QObject {
    Q_OBJECT

public:
    ToolController(OrganView& view, Document& document, Selection& selection, Preview& preview);

    void connectActions(const Actions& actions);

private:
    void bind(QAction* action, ViewTool tool);
    void updateTools();
    void allow(QAction* action, ViewTool tool, const QString& does, const QString& whyNot);
    void updateHint();

    OrganView& m_view;
    Document& m_document;
    Selection& m_selection;
    Preview& m_preview;
    Actions m_actions;
};

} // namespace esm
