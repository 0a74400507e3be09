#include "app/editor/workers/poke_player.h"

#include <algorithm>

namespace esm {

namespace {

constexpr int tickLength = 16; // ms

}

PokePlayer::PokePlayer(QObject* parent) : QObject(parent) {
    m_ticks.setInterval(tickLength);
    connect(&m_ticks, &QTimer::timeout, this, &PokePlayer::tick);
}

void PokePlayer::setDuration(double seconds) {
    m_duration = seconds;
    if (m_duration <= 0) return leave();
    setTime(m_time);
    emit changed();
}

void PokePlayer::showMoment(double seconds) {
    if (m_duration <= 0) return;
    m_ticks.stop();
    m_isShown = true;
    setTime(seconds);
    emit changed();
}

void PokePlayer::play() {
    if (m_duration <= 0) return;
    if (m_time >= m_duration) m_time = 0;
    m_isShown = true;
    m_clock.start();
    m_ticks.start();
    emit changed();
}

void PokePlayer::pause() {
    m_ticks.stop();
    emit changed();
}

void PokePlayer::leave() {
    m_ticks.stop();
    m_isShown = false;
    m_time = 0;
    emit changed();
}

void PokePlayer::tick() {
    setTime(m_time + static_cast<double>(m_clock.restart()) / 1000);
    if (m_time >= m_duration) m_ticks.stop();
    emit changed();
}

void PokePlayer::setTime(double seconds) {
    m_time = std::clamp(seconds, 0.0, m_duration);
}

} // namespace esm
