#pragma once

#include "app/editor/document/document.h"
#include "app/editor/document/selection.h"
#include "widgets/view/organ_view.h"

#include <QWidget>

#include <functional>

namespace esm {

struct Actions;

/// The menus' edits, and when they can be made.
class EditController : public QObject {
    Q_OBJECT

public:
    EditController(QWidget& window, Document& document, Selection& selection, OrganView& view);

    void connectActions(const Actions& actions);
    /// Lets so many nodes carry the surface.
    void simulateNodes(std::size_t nodes);
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
    void removeScene();
    void chooseDetail();
    void chooseInside();
    void makeEvenSheet(bool isEven);
    using Simulating = std::function<Project(const Project&, const Progress&)>;
    void simulate(const Simulating& change, const QString& work, const QString& edit);
    std::optional<std::size_t> askForNodes();
    void enable(const Actions& actions);

    QWidget& m_window;
    Document& m_document;
    Selection& m_selection;
    OrganView& m_view;
    QAction* m_evenSheet = nullptr;
};

} // namespace esm
