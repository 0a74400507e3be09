#pragma once

#include <QTimer>

#include <chrono>
#include <functional>

namespace esm {

/// Longer than keys and wheel rest within one movement: what follows is another edit.
constexpr std::chrono::milliseconds pauseBetweenGestures{600};

/// A run of keys, or of the wheel, that makes one edit: over when nothing comes for a while.
class KeyRun {
public:
    explicit KeyRun(std::function<void()> finished) : m_finished(std::move(finished)) {
        m_pause.setSingleShot(true);
        m_pause.setInterval(pauseBetweenGestures);
        QObject::connect(&m_pause, &QTimer::timeout, m_finished);
    }

    void setPause(std::chrono::milliseconds pause) { m_pause.setInterval(pause); }
    void goOn() { m_pause.start(); }
    /// Now, where there is one.
    void finish() {
        if (!m_pause.isActive()) return;
        m_pause.stop();
        m_finished();
    }

private:
    std::function<void()> m_finished;
    QTimer m_pause; ///< runs since the last key
};

} // namespace esm
