#pragma once

#include "app/editor/document/document.h"
#include "app/editor/document/selection.h"
#include "core/render/camera.h"

#include <QWidget>

namespace esm {

struct Actions;

/// The menus' edits, and when they can be made.
class EditController : public QObject {
    Q_OBJECT

public:
    EditController(QWidget& window, Document& document, Selection& selection, std::function<Camera()> camera);

    void connectActions(const Actions& actions);
    /// Projects the selected photo from where the user looks; keeps its size.
    void projectFromCamera();

signals:
    /// What comes next is to shape it.
    void regionAdded();

private:
    void renameOrgan();
    void addRegion();
    void duplicateRegion();
    void removeRegion();
    void removePhoto();
    void fixRegion();
    void freeNodes();
    void chooseDetail();
    std::optional<std::size_t> askForNodes();
    void enable(const Actions& actions);

    QWidget& m_window;
    Document& m_document;
    Selection& m_selection;
    std::function<Camera()> m_camera;
};

} // namespace esm
