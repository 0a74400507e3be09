#include "app/editor/window/view_controller.h"

#include "app/editor/window/actions.h"
#include "app/editor/window/shortcuts.h"
#include "core/render/organ_scene.h"
#include "widgets/inputs/enabling.h"
#include "widgets/inputs/number_text.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace esm {

namespace {

QStringList instrumentNames(const Scene& scene) {
    QStringList names;
    for (std::size_t i = 0; i < scene.instruments.size(); ++i)
        names << QString::fromStdString(nameOf(scene, i));
    return names;
}

ViewLegend viewLegend(const ColourLegend& legend) {
    ViewLegend shown;
    shown.title = QString::fromStdString(legend.title);
    shown.unit = QString::fromStdString(legend.unit);
    shown.minimum = legend.range.minimum;
    shown.maximum = legend.range.maximum;
    for (const auto& [name, colour] : legend.entries)
        shown.entries.push_back({QString::fromStdString(name), QColor(colour[0], colour[1], colour[2])});
    return shown;
}

/// Quick work needs no announcement; of long work it is told how far it is.
constexpr std::chrono::milliseconds redrawingPatience{400}, redrawingNews{100};

/// Photos are seen without what tells of tissue, and tissue without what tells of photos.
void enableParts(const Actions& actions, bool ofTexture) {
    QList<QAction*> parts = actions.colourings->actions();
    parts << actions.showSprings << actions.showNodes << actions.showRegions;
    for (QAction* part : parts)
        enable(part, !ofTexture, whatItDoes(part),
               withKeys(QObject::tr("This belongs to the workspace Tissue ({tissue})"), actions));
    enable(actions.showProjector, ofTexture, whatItDoes(actions.showProjector),
           withKeys(QObject::tr("This belongs to the workspace Texture ({texture})"), actions));
}

} // namespace

ViewController::ViewController(OrganView& view, Document& document, Selection& selection, Preview& preview)
    : QObject(&view), m_view(view), m_document(document), m_selection(selection), m_preview(preview) {
    connect(&document, &Document::changed, this, &ViewController::followDocument);
    connect(&preview, &Preview::tissueReady, this, &ViewController::takeTissue);
    connect(&selection, &Selection::changed, this, [this] {
        rebuild(
            {&ViewController::showEllipsoids, &ViewController::markRegion, &ViewController::showProjector});
    });
    connect(&preview, &Preview::frameReady, this, &ViewController::showFrame);
    connect(&m_redrawing, &QTimer::timeout, this, &ViewController::announceRedrawing);
    connect(&m_composer, &TextureComposer::composed, this, &ViewController::showTexture);
    connect(&m_moving, &MovingPhoto::rested, this, &ViewController::expectPhotos);
    connect(&view, &OrganView::toolChanged, this, &ViewController::rebuildScene);
    followDocument(Change::everything());
}

void ViewController::connectActions(const Actions& actions) {
    connectShownParts(actions);
    enableParts(actions, false);
    connect(actions.texture, &QAction::toggled, this, [this, actions](bool on) {
        m_textureWorkspace = on;
        enableParts(actions, on);
        rebuildScene();
    });
    connect(actions.reset, &QAction::triggered, this, [this] { m_colourRange.reset(); });
}

void ViewController::connectShownParts(const Actions& actions) {
    const std::pair<QAction*, bool ViewState::*> parts[] = {{actions.showSurface, &ViewState::surface},
                                                            {actions.showWireframe, &ViewState::wireframe},
                                                            {actions.showSprings, &ViewState::springs},
                                                            {actions.showNodes, &ViewState::nodes},
                                                            {actions.showRegions, &ViewState::regions}};
    for (const auto& [action, part] : parts)
        connect(action, &QAction::toggled, this, [this, part = part](bool on) {
            m_state.*part = on;
            rebuild({&ViewController::showShownParts, &ViewController::colourTissue,
                     &ViewController::showEllipsoids, &ViewController::markRegion});
        });
    const QList<QAction*> colourings = actions.colourings->actions();
    for (std::size_t i = 0; i < everyColouring.size(); ++i)
        connect(colourings[int(i)], &QAction::toggled, this, [this, i](bool on) {
            if (!on) return;
            m_state.colourBy = everyColouring[i];
            m_colourRange.reset();
            rebuild({&ViewController::colourTissue});
        });
    connect(actions.showProjector, &QAction::toggled, this, [this](bool on) {
        m_showsProjector = on;
        rebuild({&ViewController::showProjector});
    });
    connect(actions.showBare, &QAction::toggled, this, [this](bool on) {
        m_isBare = on;
        rebuild({&ViewController::dressOrgan, &ViewController::showProjector});
    });
    connect(this, &ViewController::unseenEdit, actions.showBare,
            [bare = actions.showBare] { bare->setChecked(false); });
    connect(actions.endoscopeLight, &QAction::toggled, this, [this](bool on) {
        m_state.light = on ? SceneLight::Endoscope : SceneLight::Room;
        rebuild({&ViewController::showShownParts});
    });
    connect(actions.cut, &QAction::toggled, this, [this](bool on) {
        m_state.cut = on ? std::optional(m_cut) : std::nullopt;
        rebuild({&ViewController::showShownParts});
    });
    connect(&m_view, &OrganView::cameraChanged, this, &ViewController::followCamera);
}

void ViewController::setCut(const Cut& cut) {
    m_cut = cut;
    if (!m_state.cut) return;
    m_state.cut = cut;
    rebuild({&ViewController::showShownParts});
}

void ViewController::showMoment(std::optional<PreviewFrame> moment) {
    m_moment = std::move(moment);
    showFrame();
}

PreviewFrame ViewController::frameNow() {
    PreviewFrame living = m_preview.frame(); // taken in any case: the next is announced once it is
    return m_moment ? *m_moment : std::move(living);
}

void ViewController::followCamera() {
    if (m_state.cut && m_state.cut->side == CutSide::Viewer) rebuild({&ViewController::showShownParts});
    if (!m_view.scene().projectors.empty()) rebuild({&ViewController::showProjector});
}

void ViewController::setTheme(Theme theme) {
    m_theme = theme;
    rebuild({&ViewController::paintBackground});
}

void ViewController::followDocument(const Change& change) {
    const Project& project = m_document.project();
    // Where the hand is on one organ says nothing about the next.
    if (change.mesh) m_view.letGo();
    if (change.model() || change.stepping) m_preview.setProject(project);
    if (change.mesh || change.scene) m_fixedNodes = fixedNodesOf(*project.network, project.scene);
    if (change.mesh || change.scene) m_view.setInstrumentNames(instrumentNames(project.scene));
    if (change.picture()) composePhotos();
    if (change.picture() && m_isBare) emit unseenEdit();
    if (change.mesh) {
        m_colourRange.reset();
        rebuildScene();
        return m_view.frameOrgan();
    }
    if (change.picture()) rebuild({&ViewController::dressOrgan, &ViewController::showProjector});
    if (change.regions) rebuild({&ViewController::showEllipsoids, &ViewController::markRegion});
    if (change.regions && m_state.colourBy == ColourBy::Region) rebuild({&ViewController::colourTissue});
    if (change.scene) rebuild({&ViewController::showFixedNodes});
}

void ViewController::takeTissue() {
    const std::shared_ptr<const TissueModel> tissue = m_preview.tissue();
    if (!tissue) return;
    m_tissue = tissue;
    rebuild({&ViewController::colourTissue});
}

void ViewController::composePhotos() {
    const Project& project = m_document.project();
    m_moving.follow(project);
    if (project.layers.empty() || !project.atlas || m_moving.isMoving()) return endRedrawing();
    expectPhotos();
}

void ViewController::expectPhotos() {
    if (!m_redrawing.isActive()) m_redrawing.start(redrawingPatience);
}

void ViewController::announceRedrawing() {
    m_redrawing.start(redrawingNews);
    emit redrawing(tr("Redrawing the photos… %1 %").arg(static_cast<int>(100 * m_composer.progress())));
}

void ViewController::endRedrawing() {
    m_redrawing.stop();
    emit redrawing({});
}

void ViewController::rebuildScene() {
    const Project& project = m_document.project();
    RenderScene scene = organScene(project.mesh, project.network, project.texture.baseColour);
    PreviewFrame frame = frameNow();
    if (frame.network == project.network) {
        scene.nodePositions = std::move(frame.positions);
        scene.instruments = std::move(frame.instruments);
        m_speeds = std::move(frame.speeds);
    }
    dressOrgan(scene);
    showEllipsoids(scene);
    markRegion(scene);
    showProjector(scene);
    showShownParts(scene);
    colourTissue(scene);
    showFixedNodes(scene);
    paintBackground(scene);
    m_view.setScene(std::move(scene));
}

void ViewController::rebuild(std::initializer_list<Part> parts) {
    m_view.changeScene([&](RenderScene& scene) {
        for (const Part part : parts)
            (this->*part)(scene);
    });
}

void ViewController::dressOrgan(RenderScene& scene) {
    const Project& project = m_document.project();
    TextureComposer::Composed composed = m_composer.composition();
    const bool isDressed =
        composed.atlas && composed.atlas == project.atlas && !project.layers.empty() && !m_isBare;
    if (!isDressed) composed = {};
    scene.baseColour = project.texture.baseColour;
    scene.atlas = composed.atlas;
    scene.texturePages = composed.pages;
    scene.smallerPages = composed.smallerPages;
    if (m_isBare)
        layFinish(scene, {}, std::nullopt, nullptr);
    else
        layFinish(scene, project.layers, project.texture.finish, composed.finishPages);
    scene.projectedPhoto = m_isBare ? std::nullopt : m_moving.projected(composed);
}

void ViewController::showEllipsoids(RenderScene& scene) {
    scene.ellipsoids.clear();
    if (m_textureWorkspace || !m_state.regions) return;
    for (const Region& region : m_document.project().regions)
        if (region.ellipsoid)
            scene.ellipsoids.push_back(drawnEllipsoid(region, m_selection.region() == region.id));
}

void ViewController::markRegion(RenderScene& scene) {
    scene.marked.reset();
    const Region* selected = m_selection.selectedRegion();
    if (m_textureWorkspace || !m_state.regions || !selected || !selected->ellipsoid) return;
    const Project& project = m_document.project();
    const Region& region = *selected;
    if (m_mark.network != project.network || !sameReach(m_mark.region, region))
        m_mark = {project.network, region,
                  std::make_shared<const std::vector<double>>(nodeWeights(*project.network, region))};
    scene.marked = MarkedNodes{m_mark.weights, region.colour};
}

void ViewController::showProjector(RenderScene& scene) {
    scene.projectors.clear();
    const TextureLayer* selected = m_selection.selectedLayer();
    const bool isWanted =
        m_textureWorkspace && m_showsProjector && !m_isBare && m_view.tool().showsProjector();
    if (!isWanted || !selected || !selected->photo) return;
    DrawnProjector drawn = drawnProjector(scene, *selected, true);
    drawn.cover *= faceShare(drawn, m_view.camera());
    scene.projectors.push_back(drawn);
}

void ViewController::showFixedNodes(RenderScene& scene) {
    if (m_textureWorkspace)
        scene.fixedNodes.clear();
    else
        scene.fixedNodes = m_fixedNodes;
}

void ViewController::paintBackground(RenderScene& scene) {
    std::tie(scene.backgroundTop, scene.backgroundBottom) = viewBackground(m_theme);
}

/// The one place where the picture is made to show what the user wants to see.
void ViewController::showShownParts(RenderScene& scene) {
    ViewState state = m_state;
    if (m_textureWorkspace) state.springs = state.nodes = false;
    showParts(scene, state, m_view.camera());
}

/// Until what an edit comes to is evaluated, what was before it stays.
void ViewController::colourTissue(RenderScene& scene) {
    const Project& project = m_document.project();
    const bool isAsked = !m_textureWorkspace && (m_state.colourBy != ColourBy::Texture || scene.showSprings);
    std::optional<ColourLegend> legend;
    scene.nodePaint.reset();
    scene.springPaint.reset();
    if (isAsked && m_tissue && m_tissue->network == project.network)
        legend = colourScene(scene, m_state.colourBy, {*m_tissue, project.regions, m_speeds}, m_colourRange);
    m_view.setLegend(legend ? std::optional(viewLegend(*legend)) : std::nullopt);
}

void ViewController::showFrame() {
    PreviewFrame frame = frameNow();
    if (frame.network != m_document.project().network) return;
    m_view.setNodePositions(std::move(frame.positions));
    m_view.setInstruments(std::move(frame.instruments));
    m_view.changeScene(
        [&](RenderScene& scene) { scene.heldInstrument = m_moment ? frame.heldInstrument : std::nullopt; });
    m_speeds = std::move(frame.speeds);
    if (followsMotion(m_state.colourBy)) rebuild({&ViewController::colourTissue});
}

void ViewController::showTexture() {
    rebuild({&ViewController::dressOrgan, &ViewController::showProjector});
    if (m_moving.isMoving()) return;
    const TextureComposer::Composed composed = m_composer.composition();
    endRedrawing();
    if (composed.pages)
        emit redrawn(tr("Photos redrawn in %1 s").arg(numberText(composed.milliseconds / 1000, 2)));
    if (m_composer.isWorking()) m_redrawing.start(redrawingPatience);
    const QString failure = QString::fromStdString(composed.failure);
    emit pictureFailed(failure.isEmpty() ? QString() : tr("The photos cannot be composed: %1").arg(failure));
}

} // namespace esm
