#include "app/editor/window/actions.h"

#include "core/samples/samples.h"
#include "widgets/inputs/icon.h"

#include <QUndoStack>

#include <array>

namespace esm {

namespace {

QString tr(const char* text) {
    return QObject::tr(text);
}

QAction* make(QWidget* window, const char* text, const QKeySequence& key, const char* toolTip) {
    auto* action = new QAction(tr(text), window);
    action->setShortcut(key);
    action->setToolTip(withShortcut(tr(toolTip), action));
    window->addAction(action);
    return action;
}

QAction* makeChoice(QActionGroup* group, QAction* action, const char* iconName = nullptr) {
    action->setCheckable(true);
    if (iconName) action->setIcon(icon(QString::fromLatin1(iconName)));
    group->addAction(action);
    return action;
}

QAction* makeSwitch(QAction* action, bool on) {
    action->setCheckable(true);
    action->setChecked(on);
    return action;
}

void makeFileActions(Actions& a, QWidget* window) {
    a.open = make(window, "&Open…", QKeySequence::Open, "Open a project");
    a.import =
        make(window, "&Import organ surface…", QKeySequence(Qt::CTRL | Qt::Key_I), "Import a mesh file");
    a.save = make(window, "&Save", QKeySequence::Save, "Save the project");
    a.saveAs =
        make(window, "Save &as…", QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_S), "Save under another name");
    a.exportPackage = make(window, "&Export package…", QKeySequence(Qt::CTRL | Qt::Key_E),
                           "Write the model package for simulators");
    a.quit = make(window, "&Quit", QKeySequence::Quit, "Close the window");
    for (const auto& name : sampleNames()) {
        QString title = QString::fromStdString(name);
        title[0] = title[0].toUpper();
        auto* action = new QAction(title, window);
        a.samples.emplace_back(name, action);
    }
}

void makeEditActions(Actions& a, QWidget* window, QUndoStack* undoStack) {
    a.undo = undoStack->createUndoAction(window, tr("&Undo"));
    a.redo = undoStack->createRedoAction(window, tr("&Redo"));
    a.undo->setShortcut(QKeySequence::Undo);
    a.redo->setShortcuts(
        {QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Z), QKeySequence(Qt::CTRL | Qt::Key_Y)});
    const auto explain = [undo = a.undo, redo = a.redo, undoStack] {
        undo->setToolTip(undoStack->canUndo() ? withShortcut(undo->text(), undo) : tr("Nothing to undo"));
        redo->setToolTip(undoStack->canRedo() ? withShortcut(redo->text(), redo) : tr("Nothing to redo"));
    };
    QObject::connect(undoStack, &QUndoStack::undoTextChanged, a.undo, explain);
    QObject::connect(undoStack, &QUndoStack::redoTextChanged, a.redo, explain);
    explain();
    a.undo->setIcon(icon(QStringLiteral("undo")));
    a.redo->setIcon(icon(QStringLiteral("redo")));
    a.rename = make(window, "Rename &organ…", {}, "Give the organ another name");
    a.addRegion = make(window, "Add &region", QKeySequence(Qt::CTRL | Qt::Key_R), "Add an ellipsoid region");
    a.fixRegion =
        make(window, "&Fix nodes in region", {}, "Hold the nodes inside the selected region in space");
    a.freeNodes = make(window, "Free &all fixed nodes", {}, "Let every fixed node go");
    a.addPhoto = make(window, "Add &photo…", QKeySequence(Qt::CTRL | Qt::Key_P),
                      "Lay a photo on the organ, from the camera");
    a.fromCamera = make(window, "Photo from &camera", QKeySequence(Qt::Key_C),
                        "Throw the selected photo from where you look");
}

void makeViewActions(Actions& a, QWidget* window) {
    a.showSprings =
        makeSwitch(make(window, "Show &springs", QKeySequence(Qt::Key_S), "Draw the spring network"), false);
    a.showRegions = makeSwitch(
        make(window, "Show &regions", QKeySequence(Qt::Key_H), "Draw the regions' ellipsoids"), true);
    a.showLeft =
        makeSwitch(make(window, "&Left panels", QKeySequence(Qt::Key_F9), "Show the left panels"), true);
    a.showRight =
        makeSwitch(make(window, "Righ&t panels", QKeySequence(Qt::Key_F10), "Show the right panels"), true);
    a.frame = make(window, "&Whole organ", QKeySequence(Qt::Key_Home), "Bring the whole organ into view");
    a.lightTheme = makeSwitch(make(window, "Li&ght theme", {}, "Light colours"), false);
    a.frame->setShortcuts({QKeySequence(Qt::Key_Home), QKeySequence(Qt::Key_0)});
    int key = Qt::Key_1;
    for (const char* name : {"&Front", "&Back", "&Left", "&Right", "&Top", "B&ottom"})
        a.standardViews.push_back(make(window, name, QKeySequence(key++), "Look from this side"));
    const std::array<Qt::Key, 5> initials{Qt::Key_F, Qt::Key_B, Qt::Key_L, Qt::Key_R, Qt::Key_T};
    for (std::size_t i = 0; i < initials.size(); ++i)
        a.standardViews[i]->setShortcuts({a.standardViews[i]->shortcut(), QKeySequence(initials[i])});
}

void makeToolActions(Actions& a, QWidget* window) {
    a.tools = new QActionGroup(window);
    a.look = makeChoice(a.tools, make(window, "&Look", QKeySequence(Qt::Key_V), "Turn and shift the view"),
                        "look");
    a.pull = makeChoice(a.tools, make(window, "&Pull", QKeySequence(Qt::Key_P), "Grasp the tissue and pull"),
                        "pull");
    a.instrument = makeChoice(
        a.tools,
        make(window, "&Instrument", QKeySequence(Qt::Key_I), "Push the tissue with a round instrument"),
        "instrument");
    a.region = makeChoice(
        a.tools, make(window, "&Region", QKeySequence(Qt::Key_E), "Move and size the region's ellipsoid"),
        "region");
    a.projector = makeChoice(
        a.tools, make(window, "P&hoto", QKeySequence(Qt::Key_J), "Move and size the photo's projector"),
        "photo");
    a.pull->setChecked(true);
    a.workspaces = new QActionGroup(window);
    a.tissue = makeChoice(a.workspaces, make(window, "&Tissue", QKeySequence(Qt::CTRL | Qt::Key_1),
                                             "How the organ's tissue behaves"));
    a.texture = makeChoice(
        a.workspaces, make(window, "Te&xture", QKeySequence(Qt::CTRL | Qt::Key_2), "Photos on the organ"));
    a.tissue->setChecked(true);
    a.play = make(window, "&Play", QKeySequence(Qt::Key_Space), "Let the tissue move, or stop it");
    a.reset = make(window, "&Reset", QKeySequence(Qt::CTRL | Qt::Key_0), "Back to the shape at rest");
    a.keys = make(window, "&Keys and mouse", QKeySequence(Qt::Key_F1), "What mouse and keys do");
    a.about = make(window, "&About", {}, "About this program");
}

} // namespace

QString withShortcut(const QString& toolTip, const QAction* action) {
    const QString key = action->shortcut().toString(QKeySequence::NativeText);
    return key.isEmpty() ? toolTip : QStringLiteral("%1 (%2)").arg(toolTip, key);
}

Actions createActions(QWidget* window, QUndoStack* undoStack) {
    Actions actions{};
    makeFileActions(actions, window);
    makeEditActions(actions, window, undoStack);
    makeViewActions(actions, window);
    makeToolActions(actions, window);
    return actions;
}

} // namespace esm
