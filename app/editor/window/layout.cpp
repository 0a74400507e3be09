#include "app/editor/window/layout.h"

#include <QCoreApplication>
#include <QFontMetrics>
#include <QHBoxLayout>
#include <QMenuBar>
#include <QScrollArea>
#include <QToolBar>
#include <QToolButton>

namespace esm {

namespace {

QString tr(const char* text) {
    return QObject::tr(text);
}

/// A button that is an action: it follows its text, state and tool tip.
QPushButton* pushButton(QAction* action, QWidget* parent) {
    auto* button = new QPushButton(parent);
    button->setCheckable(action->isCheckable());
    // A click leaves the keys where they were.
    button->setFocusPolicy(Qt::TabFocus);
    const auto follow = [button, action] {
        button->setText(action->text().remove('&').remove(QChar(0x2026)));
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
    for (QAction* workspace : {actions.tissue, actions.texture})
        row->addWidget(pushButton(workspace, frame));
    return frame;
}

} // namespace

void buildMenus(QMainWindow& window, const Actions& a) {
    QMenuBar* bar = window.menuBar();
    QMenu* file = bar->addMenu(tr("&File"));
    file->addActions({a.open});
    QMenu* samples = file->addMenu(tr("Open sa&mple"));
    for (const auto& sample : a.samples)
        samples->addAction(sample.second);
    file->addAction(a.import);
    file->addSeparator();
    file->addActions({a.save, a.saveAs});
    file->addSeparator();
    file->addAction(a.exportPackage);
    file->addSeparator();
    file->addAction(a.quit);

    bar->addMenu(tr("&Edit"))->addActions({a.undo, a.redo, a.rename});

    QMenu* view = bar->addMenu(tr("&View"));
    view->addActions({a.tissue, a.texture});
    view->addSeparator();
    view->addActions({a.showSprings, a.showRegions});
    view->addSeparator();
    view->addAction(a.frame);
    QMenu* sides = view->addMenu(tr("L&ook from"));
    for (QAction* side : a.standardViews)
        sides->addAction(side);
    view->addSeparator();
    view->addActions({a.showLeft, a.showRight, a.lightTheme});

    QMenu* model = bar->addMenu(tr("&Model"));
    model->addActions({a.addRegion, a.fixRegion, a.freeNodes});
    model->addSeparator();
    model->addActions({a.addPhoto, a.fromCamera});

    QMenu* simulation = bar->addMenu(tr("&Simulation"));
    simulation->addActions({a.play, a.reset});
    bar->addMenu(tr("&Tools"))->addActions(a.tools->actions());
    bar->addMenu(tr("&Help"))->addActions({a.keys, a.about});
}

void buildToolStrip(QMainWindow& window, const Actions& a) {
    auto* strip = new QToolBar(tr("Tools"), &window);
    strip->setObjectName(QStringLiteral("toolStrip"));
    strip->setMovable(false);
    strip->setContextMenuPolicy(Qt::PreventContextMenu);
    strip->setIconSize({20, 20});
    strip->addActions({a.look, a.pull, a.instrument});
    strip->addSeparator();
    strip->addActions({a.region, a.projector});
    for (QAction* tool : a.tools->actions()) {
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

void buildTopBar(QMainWindow& window, const Actions& a) {
    auto* bar = new QToolBar(tr("Top bar"), &window);
    bar->setObjectName(QStringLiteral("topBar"));
    bar->setMovable(false);
    bar->setContextMenuPolicy(Qt::PreventContextMenu);
    auto* content = new QWidget(bar);
    auto* row = new QHBoxLayout(content);
    row->setContentsMargins(10, 6, 10, 6);
    row->setSpacing(8);

    // Both sides take the same share, so that the workspaces stay in the middle.
    auto* left = new QWidget(content);
    auto* leftRow = new QHBoxLayout(left);
    leftRow->setContentsMargins(0, 0, 0, 0);
    leftRow->addWidget(iconButton(a.undo, left));
    leftRow->addWidget(iconButton(a.redo, left));
    leftRow->addStretch();
    auto* right = new QWidget(content);
    auto* rightRow = new QHBoxLayout(right);
    rightRow->setContentsMargins(0, 0, 0, 0);
    rightRow->addStretch();
    QPushButton* play = pushButton(a.play, right);
    play->setProperty("primary", true);
    play->setObjectName(QStringLiteral("playButton"));
    // "Pause" and "Play" take the same room.
    play->setMinimumWidth(84);
    rightRow->addWidget(pushButton(a.reset, right));
    rightRow->addWidget(play);
    QPushButton* package = pushButton(a.exportPackage, right);
    rightRow->addWidget(package);
    for (QWidget* side : {left, right})
        side->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    row->addWidget(left, 1);
    row->addWidget(workspaceSwitch(a, content));
    row->addWidget(right, 1);
    bar->addWidget(content);
    content->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    window.addToolBar(Qt::TopToolBarArea, bar);
}

QDockWidget* buildColumn(QMainWindow& window, Qt::DockWidgetArea side, const QString& title,
                         std::initializer_list<QWidget*> panels) {
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

    auto* dock = new QDockWidget(title, &window);
    dock->setObjectName(title);
    dock->setTitleBarWidget(new QWidget(dock));
    dock->setFeatures(QDockWidget::NoDockWidgetFeatures);
    dock->setWidget(scroll);
    window.addDockWidget(side, dock);
    return dock;
}

} // namespace esm
