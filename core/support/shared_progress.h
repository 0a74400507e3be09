#pragma once

#include "core/support/progress.h"

#include <atomic>
#include <thread>

namespace esm {

/// Adds up what the threads of one parallel loop have done. Only the thread that made it reports, as a
/// Progress may be called on no other; once that asks to stop, the others stop as well.
class SharedProgress {
public:
    /// @param progress outlives this
    SharedProgress(const Progress& progress, std::size_t steps) : m_progress(progress), m_steps(steps) {}

    /// @throws Cancelled, which ends a loop of TBB on all its threads
    void add(std::size_t steps = 1) {
        const std::size_t done = m_done += steps;
        if (m_isStopped) throw Cancelled();
        if (!m_progress || std::this_thread::get_id() != m_reporter) return;
        m_isStopped = !m_progress(static_cast<double>(done) / static_cast<double>(m_steps));
        if (m_isStopped) throw Cancelled();
    }

private:
    const Progress& m_progress;
    std::size_t m_steps;
    std::thread::id m_reporter = std::this_thread::get_id();
    std::atomic<std::size_t> m_done = 0;
    std::atomic<bool> m_isStopped = false;
};

} // namespace esm
