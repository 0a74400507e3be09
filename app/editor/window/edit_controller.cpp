#include "app/editor/window/edit_controller.h"

#include "app/editor/dialogs/ask.h"
#include "app/editor/dialogs/attempt.h"
#include "app/editor/dialogs/fluid_question.h"
#include "app/editor/dialogs/inside_dialog.h"
#include "app/editor/dialogs/long_work.h"
#include "app/editor/dialogs/split_question.h"
#include "app/editor/edits/photo_edits.h"
#include "app/editor/edits/simulated_edit.h"
#include "app/editor/edits/starting_system.h"
#include "app/editor/window/actions.h"
#include "app/editor/window/shortcuts.h"
#include "core/authoring/even_sheet.h"
#include "core/authoring/layers.h"
#include "core/authoring/regions.h"
#include "core/model/gentle_pull.h"
#include "core/model/scene_cavities.h"
#include "core/model/scene_events.h"
#include "core/project/detail_change.h"
#include "widgets/inputs/enabling.h"
#include "widgets/inputs/number_text.h"

#include <QInputDialog>

namespace esm {

namespace {

/// A wall has nodes at every vertex of its surface and beneath them.
bool hasWall(const Project& project) {
    return project.network->lattice && isWall(project.network->lattice->filling);
}

/// About so many nodes, in the surface or throughout the body as it is now. @throws InvalidModel
/// Precondition: the organ has no wall of prisms.
Detail ofNodes(const Project& project, std::size_t nodes) {
    if (!project.network->lattice)
        return {Detail::Kind::Nodes, nodes, {}, project.network->sheet.has_value()};
    const LatticeFilling& filling = project.network->lattice->filling;
    return {Detail::Kind::Filled, 0, fillingOf(*project.mesh, filling.kind, static_cast<double>(nodes))};
}

} // namespace

EditController::EditController(QWidget& window, Document& document, Selection& selection, OrganView& view)
    : QObject(&window), m_window(window), m_document(document), m_selection(selection), m_view(view) {}

void EditController::connectActions(const Actions& actions) {
    connect(actions.rename, &QAction::triggered, this, &EditController::renameOrgan);
    connect(actions.addRegion, &QAction::triggered, this, &EditController::addRegion);
    connect(actions.duplicateRegion, &QAction::triggered, this, &EditController::duplicateRegion);
    connect(actions.removeRegion, &QAction::triggered, this, &EditController::removeRegion);
    connect(actions.removePhoto, &QAction::triggered, this, &EditController::removePhoto);
    connect(actions.fixRegion, &QAction::triggered, this, &EditController::fixRegion);
    connect(actions.freeNodes, &QAction::triggered, this, &EditController::freeNodes);
    connect(actions.removeScene, &QAction::triggered, this, &EditController::removeScene);
    connect(actions.chooseDetail, &QAction::triggered, this, &EditController::chooseDetail);
    connect(actions.chooseInside, &QAction::triggered, this, &EditController::chooseInside);
    m_evenSheet = actions.evenSheet;
    connect(actions.evenSheet, &QAction::triggered, this, &EditController::makeEvenSheet);
    connect(actions.fromCamera, &QAction::triggered, this, &EditController::projectFromCamera);
    const auto update = [this, actions] { enable(actions); };
    connect(&m_document, &Document::changed, this, update);
    connect(&m_selection, &Selection::changed, this, update);
    connect(actions.texture, &QAction::toggled, this, update);
    update();
}

void EditController::enable(const Actions& actions) {
    const auto allow = [](QAction* action, bool on, const QString& why) {
        esm::enable(action, on, whatItDoes(action), why);
    };
    const Project& project = m_document.project();
    const Region* region = m_selection.selectedRegion();
    const QString noEllipsoid = tr("Select a region with an ellipsoid first");
    allow(actions.fixRegion, region && region->ellipsoid, noEllipsoid);
    allow(actions.duplicateRegion, region && region->ellipsoid, noEllipsoid);
    allow(actions.removeRegion, region, tr("The whole organ cannot be removed: select a region first"));
    const TextureLayer* layer = m_selection.selectedLayer();
    allow(actions.removePhoto, layer, tr("No photo is selected"));
    allow(actions.freeNodes, !project.scene.fixed.empty(), tr("No node is fixed"));
    const bool texture = actions.texture->isChecked();
    const QString noPhoto =
        !texture ? withKeys(tr("Photos are placed in the workspace Texture ({texture})"), actions)
        : layer  ? tr("The selected layer has no photo, it is painted")
                 : tr("No photo is selected");
    for (QAction* ofPhoto : {actions.fromCamera, actions.lookThroughPhoto})
        allow(ofPhoto, texture && layer && layer->photo, noPhoto);
    const bool canBeCoarser = project.mesh->vertices.size() > fewestVertices;
    allow(actions.chooseDetail, canBeCoarser && !hasWall(project),
          canBeCoarser ? tr("A wall of prisms has nodes at every vertex: Model → Inside… chooses its layers, "
                            "or takes it away")
                       : tr("This model has no surface that fewer nodes could carry"));
    allow(actions.chooseInside, !project.mesh->triangles.empty(),
          tr("This model has no surface that could be filled"));
    allow(actions.evenSheet, canBeEvenSheet(project),
          tr("The organ is no surface of springs: it is solid or rigid"));
    actions.evenSheet->setChecked(project.network->sheet.has_value());
    const bool splits = !project.scene.splits.empty();
    allow(actions.playScene, hasLoads(project.scene) && !splits,
          splits ? tr("The scene splits the organ, which the window does not play yet: esmc simulate does")
                 : tr("The scene has no force, led node, pressure or instrument: Measure → Poke makes one of "
                      "a pull"));
    allow(actions.removeScene, hasEvents(project.scene), tr("Nothing happens in the project's scene"));
    const QString noSurface = tr("This model has no surface to lay a photo on");
    allow(actions.addPhoto, !project.mesh->triangles.empty(), noSurface);
    allow(actions.addPaint, !project.mesh->triangles.empty(), noSurface);
}

void EditController::renameOrgan() {
    bool accepted = false;
    const QString name = ask(m_window, [&] {
        return QInputDialog::getText(&m_window, tr("Rename organ"), tr("Name of the organ"),
                                     QLineEdit::Normal, QString::fromStdString(m_document.project().name),
                                     &accepted);
    });
    if (!accepted || name.trimmed().isEmpty()) return;
    m_document.edit(tr("Rename organ"),
                    [&](Project& project) { project.name = name.trimmed().toStdString(); });
}

void EditController::addRegion() {
    const auto seen = pickNearMiddle(m_view.sight());
    const RegionId added = m_document.newRegionId();
    m_document.edit(tr("Add region"), [&](Project& project) {
        if (seen) return placeRegion(project, added, added, seen->spot, startingSystem());
        esm::addRegion(project, added, project.network->restPositions.front(), startingSystem());
    });
    emit regionAdded();
}

void EditController::duplicateRegion() {
    const Region* region = m_selection.selectedRegion();
    if (!region || !region->ellipsoid) return;
    const RegionId original = region->id, copy = m_document.newRegionId();
    m_document.edit(tr("Duplicate region"),
                    [&](Project& project) { esm::duplicateRegion(project, original, copy); });
    emit regionAdded();
}

void EditController::removeRegion() {
    const auto region = m_selection.region();
    if (!region) return;
    m_document.edit(tr("Remove region"), [&](Project& project) { esm::removeRegion(project, *region); });
}

void EditController::removePhoto() {
    const auto photo = m_selection.photo();
    if (!photo) return;
    m_document.edit(tr("Remove photo"), [&](Project& project) { removeLayer(project, *photo); });
}

void EditController::fixRegion() {
    const Region* region = m_selection.selectedRegion();
    if (!region || !region->ellipsoid) return;
    m_document.edit(tr("Fix nodes"), [id = region->id](Project& project) { fixNodesInside(project, id); });
}

void EditController::freeNodes() {
    m_document.edit(tr("Free fixed nodes"), [](Project& project) { project.scene.fixed.clear(); });
}

void EditController::removeScene() {
    m_document.edit(tr("Remove scene"),
                    [](Project& project) { project.scene = withoutEvents(project.scene); });
}

std::optional<std::size_t> EditController::askForNodes() {
    const Project& project = m_document.project();
    const std::size_t vertices = project.mesh->vertices.size();
    const QString question = tr("Nodes that carry the surface of %1 vertices").arg(countText(vertices));
    const int now = static_cast<int>(project.network->restPositions.size());
    bool accepted = false;
    const int nodes = ask(m_window, [&] {
        return QInputDialog::getInt(&m_window, tr("Nodes to simulate"), question, now, fewestVertices,
                                    static_cast<int>(vertices), 100, &accepted);
    });
    return accepted ? std::optional(static_cast<std::size_t>(nodes)) : std::nullopt;
}

void EditController::chooseInside() {
    InsideDialog dialog(m_document.project(), &m_window);
    const int answer = ask(m_window, [&] { return dialog.exec(); });
    runLongWork(&m_window, tr("Inside of the organ"), [&](const Progress&) { dialog.stopWork(); });
    const Detail now = detailOf(*m_document.project().network), chosen = dialog.detail();
    const bool isAnother = chosen.kind != now.kind || chosen.filling != now.filling;
    if (answer != QDialog::Accepted || !isAnother) return;
    const Scene& scene = m_document.project().scene;
    if (!mayRemoveSplits(m_window, scene) || !mayRemoveFluids(m_window, scene, chosen)) return;
    const auto made = dialog.network();
    simulate(
        [made, chosen](Project project, const Progress& progress) {
            if (chosen.kind == Detail::Kind::Filled) removeFluids(project.scene);
            return made ? withNetwork(project, made, progress) : withDetail(project, chosen, progress);
        },
        tr("Making the inside"), tr("Choose the inside"));
}

/// Of a solid organ by its inside's spacing.
void EditController::chooseDetail() {
    if (m_document.project().network->lattice) return chooseInside();
    const std::size_t now = m_document.project().network->restPositions.size();
    if (const auto nodes = askForNodes(); nodes && *nodes != now) simulateNodes(*nodes);
}

void EditController::makeEvenSheet(bool isEven) {
    simulate([isEven](const Project& project,
                      const Progress& progress) { return withEvenSheet(project, isEven, progress); },
             tr("Sharing the tissue out"), isEven ? tr("Even sheet") : tr("No even sheet"));
    // The click has ticked it; the work may have been cancelled.
    m_evenSheet->setChecked(m_document.project().network->sheet.has_value());
}

void EditController::simulateNodes(std::size_t nodes) {
    if (hasWall(m_document.project())) return;
    if (!mayRemoveSplits(m_window, m_document.project().scene)) return;
    simulate(
        [nodes](const Project& project, const Progress& progress) {
            return withDetail(project, ofNodes(project, nodes), progress);
        },
        tr("Binding the surface to its nodes"), tr("Choose simulated nodes"));
}

void EditController::simulate(const Simulating& change, const QString& work, const QString& edit) {
    attempt(&m_window, tr("The organ cannot be simulated so"), [&] {
        const Project project = m_document.project();
        const Project changed = computeLong(
            &m_window, work, [&](const Progress& progress) { return change(project, progress); },
            Cancelling::Offered);
        m_document.edit(edit, [&](Project& edited) { takeSimulated(edited, changed); });
    });
}

void EditController::projectFromCamera() {
    const auto selected = m_selection.photo();
    if (!selected) return;
    m_document.edit(tr("Photo from camera"), [&](Project& project) {
        TextureLayer& layer = partOf(project.layers, *selected);
        if (!layer.photo) return;
        layer.projector = aimedByCamera(layer.projector, m_view.camera(), layer.photo->image, *project.mesh);
    });
}

} // namespace esm
