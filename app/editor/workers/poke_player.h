#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

namespace esm {

/// The moment of a motion that is shown, which goes on as fast as time does while it plays.
class PokePlayer : public QObject {
    Q_OBJECT

public:
    explicit PokePlayer(QObject* parent = nullptr);

    /// s, of what can be shown. Where nothing can, it is not shown.
    void setDuration(double seconds);
    double duration() const { return m_duration; }
    double time() const { return m_time; } ///< s
    /// Shows a moment, s, and stays there.
    void showMoment(double seconds);
    /// Shows the motion on from here; once it was shown to the end, from the start.
    void play();
    void pause();
    /// Shows no moment any more.
    void leave();
    bool isPlaying() const { return m_ticks.isActive(); }
    bool isShown() const { return m_isShown; }

signals:
    /// What any of these gives.
    void changed();

private:
    void tick();
    void setTime(double seconds);

    QTimer m_ticks;
    QElapsedTimer m_clock; ///< since the last tick
    double m_duration = 0, m_time = 0;
    bool m_isShown = false;
};

} // namespace esm
