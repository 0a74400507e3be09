#pragma once

#include "app/editor/document/document.h"
#include "app/editor/document/selection.h"
#include "widgets/view/organ_view.h"

#include <optional>

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
    std::optional<Camera> throughPhoto() const;
    void lookThroughPhoto(QAction& action);
    void followPhoto();
    bool eventFilter(QObject* watched, QEvent* event) override;

    OrganView& m_view;
    Document& m_document;
    Selection& m_selection;
    bool m_textureWorkspace = false;
    std::optional<Camera> m_lookedThrough; ///< as the photo was when it was last looked through
};

} // namespace esm
