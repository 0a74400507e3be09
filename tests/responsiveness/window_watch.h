#pragma once

#include "app/editor/window/main_window.h"

#include <atomic>
#include <chrono>
#include <thread>
#include <vector>

namespace responsiveness {

/// ms, in any order.
using Times = std::vector<double>;
double share(Times times, double below); ///< which so large a share is at or below; 0 without any

/// Looks on while a window works: how soon it answers, and how far its frames and pictures lie apart.
class WindowWatch : public QObject {
    Q_OBJECT

public:
    explicit WindowWatch(esm::MainWindow& window);
    ~WindowWatch() override;

    const Times& answers() const { return m_answers; }
    /// Processor time of the window's thread from one answer to the next: what an answer would have to wait
    /// for on a machine that does nothing else.
    const Times& busy() const { return m_busy; }
    const Times& frameGaps() const { return m_frameGaps; }
    const Times& pictureGaps() const { return m_pictureGaps; }
    /// Of the frame that came last, the number of the project that it was computed by.
    int project() const { return m_project; }

private:
    using Clock = std::chrono::steady_clock;

    void ask();
    void answer(Clock::time_point asked);
    static void noteGap(Clock::time_point& last, Times& gaps);

    esm::MainWindow& m_window;
    Times m_answers, m_busy, m_frameGaps, m_pictureGaps;
    double m_lastBusy; ///< ms, processor time of the window's thread
    Clock::time_point m_lastFrame, m_lastPicture;
    int m_project = 0;
    std::atomic<bool> m_stops = false;
    std::thread m_asking;
};

} // namespace responsiveness
