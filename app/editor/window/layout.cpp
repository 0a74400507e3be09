#include "app/editor/window/layout.h"

#include <QMenuBar>
#include <QScrollArea>
#include <QSplitter>
#include <QVBoxLayout>

namespace esm {

namespace {

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
    file->addActions({a.close, a.quit});
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
    view->addActions({a.lookFromWithin, a.lookThroughPhoto, a.orthographic, a.endoscopeLight});
    view->addSeparator();
    view->addActions({a.showLeft, a.showRight, a.fuzzyWindow, a.referenceWindow, a.lightTheme});
}

/// To all alike, in proportion: of those that are hidden too.
void shareRoom(QSplitter& splitter) {
    QList<int> sizes;
    for (int i = 0; i < splitter.count(); ++i)
        sizes.append(1000);
    splitter.setSizes(sizes);
}

void fillWith(QSplitter& splitter, const std::vector<QWidget*>& views) {
    splitter.setChildrenCollapsible(false);
    splitter.setHandleWidth(3);
    for (QWidget* view : views) {
        splitter.addWidget(view);
        splitter.setStretchFactor(splitter.indexOf(view), 1);
    }
    shareRoom(splitter);
}

/// Lies the way in which a photo and an organ, both wider than high, are seen larger.
class FittingSplitter : public QSplitter {
protected:
    void resizeEvent(QResizeEvent* event) override {
        constexpr double usualAspect = 1.15; // of what is shown
        const bool isWide = width() > usualAspect * height();
        const Qt::Orientation wanted = isWide ? Qt::Horizontal : Qt::Vertical;
        if (wanted != orientation()) {
            setOrientation(wanted);
            shareRoom(*this);
        }
        QSplitter::resizeEvent(event);
    }
};

/// It says of each action what it does, or why it cannot be used now.
QMenu* addMenu(QMenuBar& bar, const QString& title) {
    QMenu* menu = bar.addMenu(title);
    menu->setToolTipsVisible(true);
    return menu;
}

} // namespace

void fillShownMenu(QMenu* menu, const Actions& a) {
    menu->setToolTipsVisible(true);
    menu->addActions({a.showSurface, a.showWireframe, a.showSprings, a.showNodes, a.showRegions,
                      a.showProjector, a.showBare});
    QMenu* colours = menu->addMenu(QObject::tr("Colour &by"));
    colours->setToolTipsVisible(true);
    colours->addActions(a.colourings->actions());
}

void buildMenus(QMainWindow& window, const Actions& a) {
    QMenuBar* bar = window.menuBar();
    fillFileMenu(addMenu(*bar, QObject::tr("&File")), a);
    QMenu* edit = addMenu(*bar, QObject::tr("&Edit"));
    edit->addActions({a.undo, a.redo, a.history});
    edit->addSeparator();
    edit->addActions({a.duplicateRegion, a.removeRegion, a.rename});
    edit->addSeparator();
    edit->addActions({a.hidePhoto, a.duplicatePhoto, a.replacePhoto, a.removePhoto});
    edit->addSeparator();
    edit->addAction(a.shortcuts);
    fillViewMenu(addMenu(*bar, QObject::tr("&View")), a);

    QMenu* model = addMenu(*bar, QObject::tr("&Model"));
    model->addActions({a.addRegion, a.fixRegion, a.freeNodes, a.chooseDetail, a.chooseInside, a.evenSheet});
    model->addSeparator();
    model->addActions({a.addPhoto, a.addPaint, a.fromCamera});

    QMenu* simulation = addMenu(*bar, QObject::tr("&Simulation"));
    simulation->addActions({a.play, a.playScene, a.reset});
    simulation->addSeparator();
    simulation->addAction(a.removeScene);
    QMenu* tools = addMenu(*bar, QObject::tr("&Tools"));
    tools->addActions(a.tools->actions());
    tools->addSeparator();
    tools->addAction(a.letGo);
    addMenu(*bar, QObject::tr("&Help"))->addActions({a.firstSteps, a.keys, a.about});
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
    fillWith(*splitter, views);
    return splitter;
}

QWidget* beside(const std::vector<QWidget*>& views) {
    auto* splitter = new FittingSplitter;
    fillWith(*splitter, views);
    return splitter;
}

} // namespace esm
