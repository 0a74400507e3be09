#pragma once

#include "app/editor/document/document.h"
#include "app/editor/document/selection.h"
#include "app/editor/tools/motion_device.h"
#include "app/editor/window/actions.h"
#include "widgets/view/organ_view.h"

namespace esm {

/// Lets a 6-degree-of-freedom device carry the selected photo's projector, as the screen shows it; from
/// taking the cap to letting it go is one step.
class DeviceController : public QObject {
    Q_OBJECT

public:
    DeviceController(OrganView& view, Document& document, Selection& selection, MotionDevice& device);

    void connectActions(const Actions& actions) { m_texture = actions.texture; }

signals:
    void message(const QString& text);

private:
    void carry(const DeviceMotion& motion, double seconds);

    OrganView& m_view;
    Document& m_document;
    Selection& m_selection;
    QAction* m_texture = nullptr;
    QTimer m_rest;
};

} // namespace esm
