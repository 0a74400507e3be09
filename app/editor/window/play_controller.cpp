#include "app/editor/window/play_controller.h"

#include "app/editor/window/actions.h"

namespace esm {

PlayController::PlayController(QWidget& window, Preview& preview) : QObject(&window), m_preview(preview) {}

void PlayController::connectActions(const Actions& actions) {
    connect(actions.play, &QAction::triggered, &m_preview, &Preview::togglePlaying);
    connect(actions.playScene, &QAction::triggered, &m_preview, &Preview::playScene);
    connect(actions.reset, &QAction::triggered, this, [this] {
        endGentleMotion();
        m_preview.reset();
    });
    QAction* play = actions.play;
    connect(&m_preview, &Preview::statusChanged, play, [this, play] {
        const bool playing = m_preview.status().playing;
        play->setText(playing ? tr("&Pause") : tr("&Play"));
        explain(play, playing ? tr("Stop the tissue where it is") : tr("Let the tissue move"));
    });
}

void PlayController::showAlive() {
    m_preview.setGentleMotion(true);
    m_preview.setPlaying(true);
}

} // namespace esm
