#include "tests/responsiveness/window_watch.h"
#include "app/editor/workers/preview.h"
#include "widgets/view/organ_view.h"

#include <algorithm>
#include <ctime>

namespace responsiveness {

namespace {

constexpr std::chrono::milliseconds betweenQuestions{5};

double millisecondsSince(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

double processorTime() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return 1e3 * static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_nsec);
}

} // namespace

double share(Times times, double below) {
    if (times.empty()) return 0;
    std::sort(times.begin(), times.end());
    return times[static_cast<std::size_t>(below * static_cast<double>(times.size() - 1))];
}

WindowWatch::WindowWatch(esm::MainWindow& window)
    : m_window(window), m_lastBusy(processorTime()), m_lastFrame(Clock::now()), m_lastPicture(Clock::now()) {
    connect(&window.preview(), &esm::Preview::frameReady, this, [this] {
        m_project = m_window.preview().frame().project;
        noteGap(m_lastFrame, m_frameGaps);
    });
    connect(&window.view(), &esm::OrganView::drawn, this, [this] { noteGap(m_lastPicture, m_pictureGaps); });
    m_asking = std::thread([this] { ask(); });
}

WindowWatch::~WindowWatch() {
    m_stops = true;
    m_asking.join();
}

/// As keys and mouse come: whenever they do, and behind what the window is at.
void WindowWatch::ask() {
    while (!m_stops) {
        const Clock::time_point asked = Clock::now();
        QMetaObject::invokeMethod(
            this, [this, asked] { answer(asked); }, Qt::QueuedConnection);
        std::this_thread::sleep_for(betweenQuestions);
    }
}

void WindowWatch::answer(Clock::time_point asked) {
    m_answers.push_back(millisecondsSince(asked));
    const double now = processorTime();
    m_busy.push_back(now - m_lastBusy);
    m_lastBusy = now;
}

void WindowWatch::noteGap(Clock::time_point& last, Times& gaps) {
    gaps.push_back(millisecondsSince(last));
    last = Clock::now();
}

} // namespace responsiveness
