#include "app/editor/window/columns.h"

#include "app/editor/panels/fuzzy/fuzzy_workbench.h"
#include "app/editor/panels/organ/fluid_panel.h"
#include "app/editor/panels/organ/model_panel.h"
#include "app/editor/panels/texture/atlas_panel.h"
#include "app/editor/panels/texture/landmarks_panel.h"
#include "app/editor/panels/texture/photo_panel.h"
#include "app/editor/panels/texture/photos_panel.h"
#include "app/editor/panels/texture/preparation_panel.h"
#include "app/editor/panels/texture/projector_panel.h"
#include "app/editor/panels/texture/wet_look_panel.h"
#include "app/editor/panels/tissue/ellipsoid_panel.h"
#include "app/editor/panels/tissue/regions_panel.h"
#include "app/editor/panels/tissue/tissue_panel.h"

namespace esm {

namespace {

using Panels = std::vector<QWidget*>;

/// Options of a tool in hand stand above all else.
Panels underOptions(const ColumnContext& c, ToolWorkspace workspace, const Panels& panels) {
    Panels column = c.tools.makeOptions(ToolOptions::Column, workspace);
    column.insert(column.end(), panels.begin(), panels.end());
    return column;
}

void addTissue(Workspaces& workspaces, const ColumnContext& c) {
    auto* regions = new RegionsPanel(c.document, c.selection);
    regions->setAddAction(c.actions.addRegion);
    regions->setMenuActions({c.actions.duplicateRegion});
    auto* reach = new SystemReach(c.document, c.selection, &workspaces);
    auto* workbench = new FuzzyWorkbench(c.document, c.selection, *reach);
    workbench->setWindowAction(c.actions.fuzzyWindow);
    workspaces.add(
        Workspace::Tissue,
        {Workspaces::tr("Organ"),
         {new ModelPanel(c.document, c.preview), regions, new EllipsoidPanel(c.document, c.selection)}},
        {{Workspaces::tr("Tissue"), underOptions(c, ToolWorkspace::Tissue,
                                                 {new TissuePanel(c.document, c.selection, *reach),
                                                  new FluidPanel(c.document, c.preview)})},
         {Workspaces::tr("Fuzzy system"), {workbench}}});
}

/// A layer that is painted has nothing to prepare or to place.
void showOfPhotosOnly(const Panels& panels, Workspaces& workspaces, const ColumnContext& c) {
    const auto show = [panels, &selection = c.selection] {
        const TextureLayer* layer = selection.selectedLayer();
        const bool isPainted = layer && !layer->photo;
        for (QWidget* panel : panels)
            panel->setVisible(!isPainted);
    };
    QObject::connect(&c.selection, &Selection::changed, &workspaces, show);
    QObject::connect(&c.document, &Document::changed, &workspaces, show);
}

void addTexture(Workspaces& workspaces, const ColumnContext& c) {
    auto* photos = new PhotosPanel(c.document, c.selection);
    photos->setAddAction(c.actions.addPhoto);
    photos->setMenuActions({c.actions.hidePhoto, c.actions.duplicatePhoto, c.actions.replacePhoto});
    photos->setPaintAction(c.actions.addPaint);
    auto* preparation = new PreparationPanel(c.preparations);
    QObject::connect(preparation, &PreparationPanel::largeViewAsked, &workspaces, c.showLargePhoto);
    auto* projector = new ProjectorPanel(c.document, c.selection);
    projector->setFromCameraAction(c.actions.fromCamera);
    projector->setLookThroughAction(c.actions.lookThroughPhoto);
    auto* landmarks = new LandmarksPanel(c.landmarking);
    landmarks->setToolAction(c.actions.tool(QStringLiteral("landmarks")));
    showOfPhotosOnly({preparation, projector, landmarks}, workspaces, c);
    workspaces.add(Workspace::Texture, {Workspaces::tr("Photos"), {photos, new AtlasPanel(c.document)}},
                   {{Workspaces::tr("Photo"),
                     underOptions(c, ToolWorkspace::Texture,
                                  {preparation, new PhotoPanel(c.document, c.selection),
                                   new WetLookPanel(c.document, c.selection), projector, landmarks})}});
}

} // namespace

void addColumns(Workspaces& workspaces, const ColumnContext& context) {
    addTissue(workspaces, context);
    addTexture(workspaces, context);
    workspaces.add(Workspace::Measure, {Workspaces::tr("Measure"), {&context.measure}}, {});
}

} // namespace esm
