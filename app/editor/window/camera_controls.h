#pragma once

#include "app/editor/document/document.h"
#include "app/editor/document/selection.h"
#include "widgets/view/organ_view.h"

namespace esm {

struct Actions;

/// Where one looks from: what keys and menu do with the view's camera.
class CameraControls : public QObject {
    Q_OBJECT

public:
    CameraControls(OrganView& view, Document& document, Selection& selection);

    void connectActions(const Actions& actions);

signals:
    void message(const QString& text);

private:
    void frameSelection();
    void lookFromWithin(QAction& action);

    OrganView& m_view;
    Document& m_document;
    Selection& m_selection;
    bool m_textureWorkspace = false;
};

} // namespace esm
