#include "app/editor/window/poke_screen.h"

#include "app/editor/dialogs/long_work.h"
#include "app/editor/panels/measure/measurement_file.h"
#include "app/editor/window/actions.h"
#include "app/editor/workers/poke_film.h"
#include "app/editor/workers/poke_scene.h"
#include "core/support/letters.h"

#include <algorithm>

namespace esm {

namespace {

/// As a name's ending says.
bool isFilm(const std::filesystem::path& file) {
    return endingOf(file) == ".avi";
}

} // namespace

PokeScreen::PokeScreen(OrganView& view, ViewController& controller, Preview& preview, PokeTest& test)
    : QObject(&view), m_view(view), m_former(new OrganView), m_controller(controller), m_preview(preview),
      m_test(test), m_caption(new ViewCaption(view, tr("now"))) {
    new ViewCaption(*m_former, tr("before"));
    m_caption->hide();
    m_former->setObjectName(QStringLiteral("formerView"));
    m_former->setAccessibleName(tr("The organ as it moved before"));
    m_former->hide();
    connect(&test, &PokeTest::changed, this, &PokeScreen::show);
    connect(&test.player(), &PokePlayer::changed, this, &PokeScreen::show);
    connect(&view, &OrganView::cameraChanged, this, [this] { followCamera(m_view, *m_former); });
    connect(m_former, &OrganView::cameraChanged, this, [this] { followCamera(*m_former, m_view); });
}

void PokeScreen::connectActions(const Actions& actions) {
    QAction* look = actions.tool(QStringLiteral("look"));
    m_takeLook = [look] { look->trigger(); };
    // Who takes a tool wants the living organ.
    connect(actions.tools, &QActionGroup::triggered, this, [this, look](const QAction* tool) {
        if (tool != look) m_test.player().leave();
    });
    connect(actions.play, &QAction::triggered, this, [this] {
        if (m_playedBefore) m_playedBefore = false; // whether it plays is the user's choice now
        m_test.player().leave();
    });
    for (QAction* action : {actions.playScene, actions.reset})
        connect(action, &QAction::triggered, &m_test.player(), &PokePlayer::leave);
    connect(&m_test, &PokeTest::recordingBegan, this,
            [pull = actions.tool(QStringLiteral("pull")),
             instrument = actions.tool(QStringLiteral("instrument"))] {
                if (!pull->isChecked() && !instrument->isChecked()) pull->trigger();
            });
}

void PokeScreen::show() {
    const PokeTest::Motion &now = m_test.latest(), &before = m_test.former();
    if (!m_test.player().isShown() || !now) return leave();
    if (!m_playedBefore) enter();
    const PokePicture& picture = pictureAt(*now, m_test.player().time());
    PreviewFrame frame;
    frame.network = now->project.network;
    frame.positions = inDoubles(picture.positions);
    frame.heldInstrument = picture.instrument;
    m_controller.showMoment(std::move(frame));
    const bool compares = before && before != now;
    if (compares) showFormer(*before);
    m_former->setVisible(compares);
    m_caption->setVisible(compares);
}

void PokeScreen::enter() {
    m_playedBefore = m_preview.isToPlay();
    m_preview.setPlaying(false);
    if (m_takeLook) m_takeLook();
}

void PokeScreen::leave() {
    if (!m_playedBefore) return;
    if (*std::exchange(m_playedBefore, std::nullopt)) m_preview.setPlaying(true);
    m_controller.showMoment(std::nullopt);
    m_former->hide();
    m_caption->hide();
}

void PokeScreen::showFormer(const PokeMotion& motion) {
    m_former->setScene(sceneAt(m_view.scene(), motion, m_test.player().time()));
    followCamera(m_view, *m_former);
}

void PokeScreen::followCamera(OrganView& from, OrganView& to) {
    if (m_isFollowing || !m_playedBefore || from.camera() == to.camera()) return;
    m_isFollowing = true;
    to.setCamera(from.camera());
    m_isFollowing = false;
}

void PokeScreen::saveFilm(const Document& document) {
    const PokeTest::Motion &now = m_test.latest(), &before = m_test.former();
    if (!now) return;
    const double aspect = static_cast<double>(m_view.width()) / std::max(1, m_view.height());
    const PokeFilm film{m_view.scene(), m_view.camera(), aspect, now, before == now ? nullptr : before};
    const QString written = writeMeasurement(
        m_view.window(),
        fileForOthers(document, tr("Save film"),
                      tr("Films (*.avi);;Pictures, a file for each moment (*.png)"),
                      {QStringLiteral(".avi"), QStringLiteral(".png")}),
        tr("The film was not written"), [&](const std::filesystem::path& file) {
            const auto write = isFilm(file) ? writeFilm : writeFilmPictures;
            runLongWork(
                m_view.window(), tr("Drawing the film"),
                [&](const Progress& progress) { write(film, file, progress); }, Cancelling::UntilDone);
        });
    if (!written.isEmpty()) emit message(written);
}

} // namespace esm
