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
    const Times& frameGaps() const { return m_frameGaps; }
    const Times& pictureGaps() const { return m_pictureGaps; }
    /// Of the frame that came last, the number of the project that it was computed by.
    int project() const { return m_project; }

private:
    using Clock = std::chrono::steady_clock;

    void ask();
    static void noteGap(Clock::time_point& last, Times& gaps);

    esm::MainWindow& m_window;
    Times m_answers, m_frameGaps, m_pictureGaps;
    Clock::time_point m_lastFrame, m_lastPicture;
    int m_project = 0;
    std::atomic<bool> m_stops = false;
    std::thread m_asking;
};

} // namespace responsiveness
