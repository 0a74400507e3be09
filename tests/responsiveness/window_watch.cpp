#include "tests/responsiveness/window_watch.h"

#include <algorithm>

namespace responsiveness {

namespace {

constexpr std::chrono::milliseconds betweenQuestions{5};

double millisecondsSince(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

} // namespace

double share(Times times, double below) {
    if (times.empty()) return 0;
    std::sort(times.begin(), times.end());
    return times[static_cast<std::size_t>(below * static_cast<double>(times.size() - 1))];
}

WindowWatch::WindowWatch(esm::MainWindow& window)
    : m_window(window), m_lastFrame(Clock::now()), m_lastPicture(Clock::now()) {
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
            this, [this, asked] { m_answers.push_back(millisecondsSince(asked)); }, Qt::QueuedConnection);
        std::this_thread::sleep_for(betweenQuestions);
    }
}

void WindowWatch::noteGap(Clock::time_point& last, Times& gaps) {
    gaps.push_back(millisecondsSince(last));
    last = Clock::now();
}

} // namespace responsiveness
