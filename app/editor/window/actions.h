#pragma once

#include "widgets/inputs/action_texts.h"

#include <QActionGroup>
#include <QMenu>
#include <QWidget>

#include <string>
#include <vector>

class QUndoStack;

namespace esm {

/// Everything the window can be asked to do. The window owns the actions; controllers connect to them.
struct Actions {
    QAction *open, *save, *saveAs, *import, *exportPackage, *close, *quit;
    QMenu* recent;                                         ///< filled by who knows the files
    std::vector<std::pair<std::string, QAction*>> samples; ///< by the sample's name
    QAction *undo, *redo, *history, *rename, *duplicateRegion, *removeRegion;
    QAction *hidePhoto, *duplicatePhoto, *replacePhoto, *removePhoto;
    QAction* shortcuts;
    QAction *showSurface, *showWireframe, *showSprings, *showNodes, *showRegions, *showProjector, *showBare;
    QActionGroup* colourings; ///< one per ColourBy, in their order
    QAction *frame, *frameSelection, *orthographic, *endoscopeLight, *cut, *lookFromWithin, *lookThroughPhoto;
    QAction *showLeft, *showRight, *fuzzyWindow, *referenceWindow, *lightTheme;
    std::vector<QAction*> standardViews; ///< front, back, left, right, top, bottom
    QAction *addRegion, *fixRegion, *freeNodes, *chooseDetail, *chooseInside, *evenSheet;
    QAction *addPhoto, *addPaint, *fromCamera;
    QAction *play, *playScene, *removeScene, *reset, *letGo;
    QAction *about, *keys, *firstSteps;
    QActionGroup* tools; ///< in the order of the table
    QActionGroup* workspaces;
    QAction *tissue, *texture, *measure;

    /// That takes the tool of this name. @throws std::out_of_range where the table has none
    QAction* tool(const QString& name) const;
};

Actions createActions(QWidget* window, QUndoStack* undoStack);

} // namespace esm
