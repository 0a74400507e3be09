#include "app/editor/window/actions.h"

#include "app/editor/tools/tool_table.h"
#include "core/render/colouring.h"
#include "core/samples/samples.h"
#include "widgets/inputs/icon.h"

#include <QCoreApplication>
#include <QUndoStack>

#include <array>
#include <stdexcept>

namespace esm {

namespace {

class ActionMaker {
    Q_DECLARE_TR_FUNCTIONS(ActionMaker)

public:
    explicit ActionMaker(QWidget* window) : m_window(window), m_actions() {}

    Actions makeAll(QUndoStack* undoStack);

private:
    QAction* make(const QString& text, const QKeySequence& key, const QString& toolTip);
    QAction* makeSwitch(QAction* action, bool on);
    QAction* makeWorkspace(QAction* action);

    void makeFileActions();
    void makeEditActions(QUndoStack* undoStack);
    void makeModelActions();
    void makeShownParts();
    void makeColourings();
    void makeCameraActions();
    void makeViewActions();
    void makeTools();
    void makeWorkspaces();
    void makePlayActions();

    QWidget* m_window;
    Actions m_actions;
};

QAction* ActionMaker::make(const QString& text, const QKeySequence& key, const QString& toolTip) {
    auto* action = new QAction(text, m_window);
    action->setShortcut(key);
    explain(action, toolTip);
    m_window->addAction(action);
    return action;
}

QAction* ActionMaker::makeSwitch(QAction* action, bool on) {
    action->setCheckable(true);
    action->setChecked(on);
    return action;
}

QAction* ActionMaker::makeWorkspace(QAction* action) {
    action->setCheckable(true);
    m_actions.workspaces->addAction(action);
    return action;
}

void ActionMaker::makeFileActions() {
    Actions& a = m_actions;
    a.open = make(tr("&Open…"), QKeySequence::Open, tr("Open a project"));
    a.recent = new QMenu(tr("Open &recent"), m_window);
    a.import = make(tr("&Import organ surface…"), QKeySequence("Ctrl+I"), tr("Import a mesh file"));
    a.save = make(tr("&Save"), QKeySequence::Save, tr("Save the project"));
    a.saveAs = make(tr("Save &as…"), QKeySequence("Ctrl+Shift+S"), tr("Save under another name"));
    a.exportPackage =
        make(tr("&Export…"), QKeySequence("Ctrl+E"), tr("Write a file for simulators and viewers"));
    a.close = make(tr("&Close"), QKeySequence::Close, tr("Leave this organ for the start page"));
    a.quit = make(tr("&Quit"), QKeySequence::Quit, tr("Close the window"));
    for (const auto& name : sampleNames()) {
        QString title = QString::fromStdString(name);
        title[0] = title[0].toUpper();
        a.samples.emplace_back(name, new QAction(title, m_window));
    }
}

void ActionMaker::makeEditActions(QUndoStack* undoStack) {
    Actions& a = m_actions;
    a.undo = undoStack->createUndoAction(m_window, tr("&Undo"));
    a.redo = undoStack->createRedoAction(m_window, tr("&Redo"));
    a.undo->setShortcut(QKeySequence::Undo);
    a.redo->setShortcuts({QKeySequence("Ctrl+Shift+Z"), QKeySequence("Ctrl+Y")});
    const auto explain = [undo = a.undo, redo = a.redo, undoStack] {
        enable(undo, undoStack->canUndo(), undo->iconText(), tr("Nothing to undo"));
        enable(redo, undoStack->canRedo(), redo->iconText(), tr("Nothing to redo"));
    };
    QObject::connect(undoStack, &QUndoStack::undoTextChanged, a.undo, explain);
    QObject::connect(undoStack, &QUndoStack::redoTextChanged, a.redo, explain);
    explain();
    a.undo->setIcon(icon(QStringLiteral("undo")));
    a.redo->setIcon(icon(QStringLiteral("redo")));
    a.history =
        make(tr("Undo &history…"), QKeySequence("Ctrl+H"), tr("Every step, to go back to or forward to"));
    a.rename = make(tr("Rename &organ…"), {}, tr("Give the organ another name"));
    a.duplicateRegion =
        make(tr("&Duplicate region"), QKeySequence("Ctrl+D"), tr("Add a copy of the selected region"));
    a.removeRegion = make(tr("Remove re&gion"), {}, tr("Remove the selected region"));
    a.hidePhoto = make(tr("Hide or sho&w photo"), QKeySequence("Ctrl+Shift+H"),
                       tr("Hide the selected photo or paint layer, or show it again"));
    a.duplicatePhoto = make(tr("Dupli&cate photo"), QKeySequence("Ctrl+J"),
                            tr("Add a copy of the selected photo or paint layer, just above it"));
    a.replacePhoto =
        make(tr("Rep&lace photo…"), {},
             tr("Lay another file in the place of the selected photo, which keeps its placement, "
                "mask, landmarks and strokes"));
    a.removePhoto = make(tr("Remove &photo"), {}, tr("Remove the selected photo"));
    a.shortcuts = make(tr("&Shortcuts…"), {}, tr("The key of every action, to be changed"));
}

void ActionMaker::makeModelActions() {
    Actions& a = m_actions;
    a.addRegion = make(tr("Add &region"), QKeySequence("Ctrl+R"),
                       tr("Add a region where the organ is seen in the middle of the view"));
    a.fixRegion =
        make(tr("&Fix nodes in region"), {}, tr("Hold the nodes inside the selected region in space"));
    a.freeNodes = make(tr("Free &all fixed nodes"), {}, tr("Let every fixed node go"));
    a.chooseDetail = make(tr("&Nodes to simulate…"), {},
                          tr("Simulate fewer nodes under the full surface, or every vertex; of a solid "
                             "organ other nodes inside"));
    a.chooseInside = make(tr("&Inside…"), {},
                          tr("Fill the organ with nodes and springs, give it a wall, or make it hollow"));
    a.evenSheet =
        make(tr("&Even sheet"), {},
             tr("Share the tissue out over the springs so that the surface is as firm however it is "
                "meshed; off, every spring has its tissue's constant"));
    a.evenSheet->setCheckable(true);
    a.addPhoto =
        make(tr("Add &photo…"), QKeySequence("Ctrl+P"), tr("Lay a photo on the organ, from the camera"));
    a.addPaint = make(tr("Add pain&t layer"), QKeySequence("Ctrl+L"),
                      tr("Add a layer that is painted on the organ with the brush"));
    a.fromCamera = make(tr("Photo from &camera"), QKeySequence(Qt::Key_C),
                        tr("Project the selected photo from where you look"));
}

void ActionMaker::makeShownParts() {
    Actions& a = m_actions;
    a.showSurface =
        makeSwitch(make(tr("Surf&ace"), QKeySequence(Qt::Key_U), tr("Draw the organ's surface")), true);
    a.showWireframe = makeSwitch(
        make(tr("&Wireframe"), QKeySequence(Qt::Key_L), tr("Draw the edges of the surface's triangles")),
        false);
    a.showSprings = makeSwitch(make(tr("&Springs"), QKeySequence(Qt::Key_S),
                                    tr("Draw all springs, coloured by their constant or as chosen")),
                               false);
    a.showNodes =
        makeSwitch(make(tr("&Nodes"), QKeySequence(Qt::Key_N), tr("Draw the simulated nodes")), false);
    a.showRegions =
        makeSwitch(make(tr("&Regions"), QKeySequence(Qt::Key_H), tr("Draw the regions' ellipsoids")), true);
    a.showBare =
        makeSwitch(make(tr("Before an&d after"), QKeySequence(Qt::Key_B),
                        tr("Show the organ as it is without photos and paint, in its base colour; who "
                           "holds the key has a look until it comes up")),
                   false);
    a.showProjector =
        makeSwitch(make(tr("Pro&jector"), QKeySequence("Shift+H"),
                        tr("Draw the box of the selected photo's projector while the tool Photo is in hand")),
                   true);
}

void ActionMaker::makeColourings() {
    Actions& a = m_actions;
    a.colourings = new QActionGroup(m_window);
    const QString grows =
        tr("The scale begins at 0 and ends at a round value, which grows with the motion until "
           "Reset");
    const std::array<std::pair<QString, QString>, everyColouring.size()> texts{
        {{tr("&Texture"), tr("The surface's own colours; springs by their constant")},
         {tr("&Spring constant"), tr("N/m, of springs and of the tissue at each node")},
         {tr("&Viscosity"), tr("N·s/m, of springs and of the tissue at each node")},
         {tr("&Mass"), tr("g, of each node")},
         {tr("St&rain"), tr("How much springs are longer or shorter than at rest, %. %1").arg(grows)},
         {tr("S&peed"), tr("mm/s, of each node. %1").arg(grows)},
         {tr("R&egion"), tr("The region that each node belongs to, in its colour")}}};
    for (std::size_t i = 0; i < texts.size(); ++i) {
        QAction* colouring = make(texts[i].first, {}, texts[i].second);
        colouring->setObjectName(QString::fromStdString(nameOf(everyColouring[i])));
        colouring->setCheckable(true);
        a.colourings->addAction(colouring);
    }
    a.colourings->actions().front()->setChecked(true);
}

void ActionMaker::makeCameraActions() {
    Actions& a = m_actions;
    a.frame = make(tr("Wh&ole organ"), QKeySequence(Qt::Key_Home), tr("Bring the whole organ into view"));
    a.frame->setShortcuts({QKeySequence(Qt::Key_Home), QKeySequence(Qt::Key_0)});
    a.frameSelection = make(tr("&Frame selection"), QKeySequence(Qt::Key_F),
                            tr("Bring the selected region, or the selected photo, into view"));
    a.orthographic = makeSwitch(make(tr("Ort&hographic"), QKeySequence(Qt::Key_T),
                                     tr("Look without perspective: what is as large is seen as large")),
                                false);
    a.endoscopeLight =
        makeSwitch(make(tr("Endoscope's light"), QKeySequence("Shift+E"),
                        tr("Light the organ by a lamp at the eye, as in a body, in place of a room's lamps")),
                   false);
    a.cut = makeSwitch(
        make(tr("&Cut open"), QKeySequence(Qt::Key_X), tr("Hide what lies before a plane, to look inside")),
        false);
    a.lookFromWithin =
        makeSwitch(make(tr("Look from w&ithin"), QKeySequence(Qt::Key_W),
                        tr("Put the eye inside the organ, at the selected region or the middle of the view")),
                   false);
    a.lookThroughPhoto =
        makeSwitch(make(tr("Look throu&gh the photo"), QKeySequence("Shift+C"),
                        tr("Put the eye where the selected photo is projected from, so that both coincide; "
                           "once more goes back")),
                   false);
    int key = Qt::Key_1;
    for (const QString& name :
         {tr("&Front"), tr("&Back"), tr("&Left"), tr("&Right"), tr("&Top"), tr("B&ottom")})
        a.standardViews.push_back(make(name, QKeySequence(key++), tr("Look from this side")));
}

void ActionMaker::makeViewActions() {
    Actions& a = m_actions;
    a.showLeft =
        makeSwitch(make(tr("&Left panels"), QKeySequence(Qt::Key_F9), tr("Show the left panels")), true);
    a.showRight =
        makeSwitch(make(tr("Right &panels"), QKeySequence(Qt::Key_F10), tr("Show the right panels")), true);
    a.fuzzyWindow = makeSwitch(make(tr("F&uzzy system in a window"), QKeySequence(Qt::Key_F8),
                                    tr("Rules and terms in a window of their own, beside the organ")),
                               false);
    a.referenceWindow =
        make(tr("Photo beside the &view…"), QKeySequence("Shift+P"),
             tr("Keep a photo, or another picture, in sight beside the organ, whatever tool is in hand"));
    a.lightTheme = makeSwitch(make(tr("Light the&me"), {}, tr("Light colours")), false);
}

void ActionMaker::makeTools() {
    Actions& a = m_actions;
    a.tools = new QActionGroup(m_window);
    for (const ToolRow& row : toolTable()) {
        QAction* tool = make(row.text, row.key, row.does);
        tool->setObjectName(row.name);
        tool->setCheckable(true);
        tool->setIcon(icon(row.icon));
        a.tools->addAction(tool);
    }
    a.letGo =
        make(tr("L&et go"), QKeySequence(Qt::Key_Escape), tr("End a drag and take the instrument away"));
}

void ActionMaker::makeWorkspaces() {
    Actions& a = m_actions;
    a.workspaces = new QActionGroup(m_window);
    a.tissue =
        makeWorkspace(make(tr("&Tissue"), QKeySequence("Ctrl+1"), tr("How the organ's tissue behaves")));
    a.texture = makeWorkspace(make(tr("Te&xture"), QKeySequence("Ctrl+2"), tr("Photos on the organ")));
    a.measure = makeWorkspace(
        make(tr("M&easure"), QKeySequence("Ctrl+3"), tr("How fast and how exactly the motion is computed")));
    a.tissue->setChecked(true);
}

void ActionMaker::makePlayActions() {
    Actions& a = m_actions;
    a.play = make(tr("&Play"), QKeySequence(Qt::Key_Space), tr("Let the tissue move, or stop it"));
    a.playScene = make(tr("Play &scene"), QKeySequence("Shift+Space"),
                       tr("Play the scene's forces, led nodes and instruments from rest"));
    a.removeScene = make(
        tr("Re&move scene"), {},
        tr("Remove its forces, led nodes, instruments, splits and changing pressures; what holds the organ "
           "stays"));
    a.reset = make(tr("&Reset"), QKeySequence("Ctrl+0"), tr("Back to the shape at rest"));
    a.keys = make(tr("&Keys and mouse"), QKeySequence(Qt::Key_F1), tr("What mouse and keys do"));
    a.firstSteps = make(tr("&First steps"), {}, tr("Five hints on the sample of a liver"));
    a.about = make(tr("&About"), {}, tr("About this program"));
}

Actions ActionMaker::makeAll(QUndoStack* undoStack) {
    makeFileActions();
    makeEditActions(undoStack);
    makeModelActions();
    makeShownParts();
    makeColourings();
    makeCameraActions();
    makeViewActions();
    makeTools();
    makeWorkspaces();
    makePlayActions();
    return m_actions;
}

} // namespace

QAction* Actions::tool(const QString& name) const {
    for (QAction* action : tools->actions())
        if (action->objectName() == name) return action;
    throw std::out_of_range("no tool is called " + name.toStdString());
}

Actions createActions(QWidget* window, QUndoStack* undoStack) {
    return ActionMaker(window).makeAll(undoStack);
}

} // namespace esm
