#include "app/editor/window/layout.h"

#include "app/editor/tools/tool_table.h"

#include <QCoreApplication>
#include <QFontMetrics>
#include <QHBoxLayout>
#include <QMenuBar>
#include <QScrollArea>
#include <QSplitter>
#include <QToolBar>
#include <QToolButton>

namespace esm {

namespace {

/// A button that is an action: it follows its text, state and tool tip.
QPushButton* pushButton(QAction* action, QWidget* parent) {
    auto* button = new QPushButton(parent);
    button->setCheckable(action->isCheckable());
    // A click leaves the keys where they were.
    button->setFocusPolicy(Qt::TabFocus);
    const auto follow = [button, action] {
        button->setText(plainText(action));
        button->setToolTip(action->toolTip());
        button->setEnabled(action->isEnabled());
        button->setChecked(action->isChecked());
    };
    follow();
    // Bold when chosen: the room for it is kept, so that nothing moves.
    if (action->isCheckable()) {
        QFont bold = button->font();
        bold.setBold(true);
        button->setMinimumWidth(QFontMetrics(bold).horizontalAdvance(button->text()) + 44);
    }
    QObject::connect(action, &QAction::changed, button, follow);
    QObject::connect(button, &QPushButton::clicked, action, [follow, action] {
        action->trigger();
        follow();
    });
    return button;
}

QToolButton* iconButton(QAction* action, QWidget* parent) {
    auto* button = new QToolButton(parent);
    button->setDefaultAction(action);
    button->setObjectName(QStringLiteral("barButton"));
    button->setIconSize({18, 18});
    button->setFocusPolicy(Qt::TabFocus);
    return button;
}

QWidget* workspaceSwitch(const Actions& actions, QWidget* parent) {
    auto* frame = new QFrame(parent);
    frame->setObjectName(QStringLiteral("workspaces"));
    auto* row = new QHBoxLayout(frame);
    row->setContentsMargins(3, 3, 3, 3);
    row->setSpacing(2);
    for (QAction* workspace : {actions.tissue, actions.texture, actions.measure})
        row->addWidget(pushButton(workspace, frame));
    return frame;
}

void fillFileMenu(QMenu* file, const Actions& a) {
    file->addAction(a.open);
    file->addMenu(a.recent);
    QMenu* samples = file->addMenu(QObject::tr("Open sa&mple"));
    for (const auto& sample : a.samples)
        samples->addAction(sample.second);
    file->addAction(a.import);
    file->addSeparator();
    file->addActions({a.save, a.saveAs});
    file->addSeparator();
    file->addAction(a.exportPackage);
    file->addSeparator();
    file->addAction(a.quit);
}

void fillViewMenu(QMenu* view, const Actions& a) {
    view->addActions({a.tissue, a.texture, a.measure});
    view->addSeparator();
    fillShownMenu(view, a);
    view->addAction(a.cut);
    view->addSeparator();
    view->addActions({a.frame, a.frameSelection});
    QMenu* sides = view->addMenu(QObject::tr("Loo&k from"));
    for (QAction* side : a.standardViews)
        sides->addAction(side);
    view->addActions({a.lookFromWithin, a.orthographic});
    view->addSeparator();
    view->addActions({a.showLeft, a.showRight, a.fuzzyWindow, a.lightTheme});
}

/// One side of the bar on top. Both take the same share, so that the workspaces stay in the middle.
QHBoxLayout* addSide(QHBoxLayout* bar, QWidget* content) {
    auto* side = new QWidget(content);
    auto* row = new QHBoxLayout(side);
    row->setContentsMargins(0, 0, 0, 0);
    side->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    bar->addWidget(side, 1);
    return row;
}

QPushButton* playButton(const Actions& actions, QWidget* parent) {
    QPushButton* play = pushButton(actions.play, parent);
    play->setProperty("primary", true);
    play->setObjectName(QStringLiteral("playButton"));
    // "Pause" and "Play" take the same room.
    play->setMinimumWidth(84);
    return play;
}

} // namespace

void fillShownMenu(QMenu* menu, const Actions& a) {
    menu->setToolTipsVisible(true);
    menu->addActions({a.showSurface, a.showWireframe, a.showSprings, a.showNodes, a.showRegions});
    QMenu* colours = menu->addMenu(QObject::tr("Colour &by"));
    colours->setToolTipsVisible(true);
    colours->addActions(a.colourings->actions());
}

void buildMenus(QMainWindow& window, const Actions& a) {
    QMenuBar* bar = window.menuBar();
    fillFileMenu(bar->addMenu(QObject::tr("&File")), a);
    QMenu* edit = bar->addMenu(QObject::tr("&Edit"));
    edit->addActions({a.undo, a.redo, a.history});
    edit->addSeparator();
    edit->addActions({a.duplicateRegion, a.removeRegion, a.removePhoto, a.rename});
    edit->addSeparator();
    edit->addAction(a.shortcuts);
    fillViewMenu(bar->addMenu(QObject::tr("&View")), a);

    QMenu* model = bar->addMenu(QObject::tr("&Model"));
    model->addActions({a.addRegion, a.fixRegion, a.freeNodes, a.chooseDetail});
    model->addSeparator();
    model->addActions({a.addPhoto, a.addPaint, a.fromCamera});

    QMenu* simulation = bar->addMenu(QObject::tr("&Simulation"));
    simulation->addActions({a.play, a.playScene, a.reset});
    QMenu* tools = bar->addMenu(QObject::tr("&Tools"));
    tools->addActions(a.tools->actions());
    tools->addSeparator();
    tools->addAction(a.letGo);
    bar->addMenu(QObject::tr("&Help"))->addActions({a.firstSteps, a.keys, a.about});
}

void buildToolStrip(QMainWindow& window, const Actions& a) {
    auto* strip = new QToolBar(QObject::tr("Tools"), &window);
    strip->setObjectName(QStringLiteral("toolStrip"));
    strip->setMovable(false);
    strip->setContextMenuPolicy(Qt::PreventContextMenu);
    strip->setIconSize({20, 20});
    // Those of every workspace come first.
    bool isEverywhere = true;
    for (const ToolRow& row : toolTable()) {
        if (isEverywhere && row.workspace != ToolWorkspace::Any) strip->addSeparator();
        isEverywhere = row.workspace == ToolWorkspace::Any;
        QAction* tool = a.tool(row.name);
        strip->addAction(tool);
        auto* button = qobject_cast<QToolButton*>(strip->widgetForAction(tool));
        button->setFocusPolicy(Qt::TabFocus);
        button->setFixedSize(34, 34);
    }
    strip->setFixedWidth(46);
    // Its margins lie in the style sheet, which knows it by a name that it did not have when it was made.
    strip->ensurePolished();
    QEvent named(QEvent::StyleChange);
    QCoreApplication::sendEvent(strip, &named);
    window.addToolBar(Qt::LeftToolBarArea, strip);
}

void buildTopBar(QMainWindow& window, const Actions& a, const std::vector<QWidget*>& toolOptions) {
    auto* bar = new QToolBar(QObject::tr("Top bar"), &window);
    bar->setObjectName(QStringLiteral("topBar"));
    bar->setMovable(false);
    bar->setContextMenuPolicy(Qt::PreventContextMenu);
    auto* content = new QWidget(bar);
    auto* row = new QHBoxLayout(content);
    row->setContentsMargins(10, 6, 10, 6);
    row->setSpacing(8);

    QHBoxLayout* left = addSide(row, content);
    left->addWidget(iconButton(a.undo, content));
    left->addWidget(iconButton(a.redo, content));
    for (QWidget* options : toolOptions)
        left->addWidget(options);
    left->addStretch();
    row->addWidget(workspaceSwitch(a, content));
    QHBoxLayout* right = addSide(row, content);
    right->addStretch();
    right->addWidget(pushButton(a.reset, content));
    right->addWidget(playButton(a, content));
    right->addWidget(pushButton(a.exportPackage, content));

    bar->addWidget(content);
    content->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    window.addToolBar(Qt::TopToolBarArea, bar);
}

QDockWidget* buildColumn(QMainWindow& window, Qt::DockWidgetArea side, const QString& title,
                         const std::vector<QWidget*>& panels) {
    auto* body = new QWidget;
    body->setObjectName(QStringLiteral("columnBody"));
    auto* column = new QVBoxLayout(body);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    for (QWidget* panel : panels)
        column->addWidget(panel);
    column->addStretch();

    auto* scroll = new QScrollArea;
    scroll->setObjectName(QStringLiteral("column"));
    scroll->setWidget(body);
    scroll->setWidgetResizable(true);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setFocusPolicy(Qt::NoFocus); // it follows the control that has the keys

    auto* dock = new QDockWidget(title, &window);
    dock->setObjectName(title);
    dock->setTitleBarWidget(new QWidget(dock));
    dock->setFeatures(QDockWidget::NoDockWidgetFeatures);
    dock->setWidget(scroll);
    window.addDockWidget(side, dock);
    return dock;
}

QWidget* stacked(const std::vector<QWidget*>& views) {
    auto* splitter = new QSplitter(Qt::Vertical);
    splitter->setChildrenCollapsible(false);
    splitter->setHandleWidth(3);
    QList<int> sizes; // in proportion, of those that are hidden too
    for (QWidget* view : views) {
        splitter->addWidget(view);
        splitter->setStretchFactor(splitter->indexOf(view), 1);
        sizes.append(1000);
    }
    splitter->setSizes(sizes);
    return splitter;
}

} // namespace esm
