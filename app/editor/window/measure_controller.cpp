#include "app/editor/window/measure_controller.h"

#include "app/editor/dialogs/attempt.h"
#include "app/editor/dialogs/long_work.h"
#include "app/editor/panels/measure/accuracy_view.h"
#include "app/editor/panels/measure/poke_view.h"
#include "app/editor/panels/measure/press_view.h"
#include "app/editor/window/shortcuts.h"
#include "app/editor/workers/pulled_scene.h"
#include "core/support/errors.h"

namespace esm {

MeasureController::MeasureController(Document& document, Preview& preview, VirtualTest& test, PokeTest& poke,
                                     QObject* parent)
    : QObject(parent), m_document(document), m_actions(), m_poke(poke), m_charts(new QStackedWidget) {
    auto* accuracy = new SpeedAndAccuracy(document, preview, this);
    m_column = new MeasureColumn(document, *accuracy, test, poke);
    auto* runs = new AccuracyView(document, *accuracy);
    auto* press = new PressView(document, test);
    m_charts->addWidget(runs);
    m_charts->addWidget(press);
    auto* moved = new PokeView(document, poke);
    m_charts->addWidget(moved);
    connect(moved, &PokeView::message, this, &MeasureController::message);
    connect(moved, &PokeView::filmAsked, this, &MeasureController::filmAsked);
    connect(&m_column->pokePanel(), &PokePanel::sceneAsked, this, &MeasureController::makeScene);
    m_charts->hide();
    connect(runs, &AccuracyView::message, this, &MeasureController::message);
    connect(press, &PressView::message, this, &MeasureController::message);
}

void MeasureController::connectParts(const Workspaces& workspaces, const Actions& actions) {
    m_actions = actions;
    QAction* finger = actions.tool(QStringLiteral("finger"));
    m_column->testPanel().setPlaceAction(finger);
    connect(&workspaces, &Workspaces::shown, m_charts, [this](Workspace shown) {
        m_charts->setVisible(shown == Workspace::Measure);
        if (shown != Workspace::Measure) m_poke.player().leave();
    });
    connect(m_column, &MeasureColumn::chosen, this, [this](MeasurePage page) {
        m_charts->setCurrentIndex(static_cast<int>(page));
        if (page != MeasurePage::Poke) m_poke.player().leave();
        takeTool();
    });
    connect(actions.measure, &QAction::triggered, this, &MeasureController::takeTool);
    connect(finger, &QAction::triggered, m_column, [this] { m_column->choose(MeasurePage::VirtualTest); });
}

/// By the organ's tissue, which says what the hand took hold of.
void MeasureController::makeScene() {
    attempt(m_column, tr("The pull was not made the scene"), [&] {
        const Poke poke = m_poke.poke().value();
        const Project project = m_document.project();
        const auto scene = computeLong(m_column, tr("Looking at the organ"), [&](const Progress&) {
            return sceneOfPull(poke, project, evaluateModel(project));
        });
        if (!scene)
            throw InvalidModel("the pull took hold of fixed nodes alone; record one that pulls at others");
        m_document.edit(tr("Make the pull the scene"), [&](Project& edited) { edited.scene = *scene; });
        emit message(withKeys(
            tr("The first pull is the project's scene now: Play scene ({playScene}) plays it"), m_actions));
    });
}

/// The finger comes and goes with its page; any other tool in hand may stay.
void MeasureController::takeTool() {
    QAction* finger = m_actions.tool(QStringLiteral("finger"));
    if (m_column->page() == MeasurePage::VirtualTest)
        finger->trigger();
    else if (finger->isChecked())
        m_actions.tool(QStringLiteral("pull"))->trigger();
}

} // namespace esm
