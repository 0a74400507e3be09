#pragma once

#include <condition_variable>
#include <mutex>
#include <thread>

namespace esm {

/// Ctrl-C and SIGTERM. Work that reports its progress is asked to stop; what does not listen within a moment
/// is ended from outside, which is safe because every output is written atomically. Make one at the start of
/// main(), before any other thread: threads inherit the blocked signals.
class Interruption {
public:
    Interruption();
    Interruption(const Interruption&) = delete;
    Interruption& operator=(const Interruption&) = delete;
    ~Interruption();

    bool requested() const;

    /// Nothing stops the work any more: for the moment in which several outputs take their places together.
    /// @throws Cancelled when it was to stop already
    void disarm();
    /// The work has stopped as it was asked to: nothing ends it from outside any more, with words of its own.
    void acknowledge();

private:
    void watch();

    mutable std::mutex m_mutex;
    std::condition_variable m_disarming;
    bool m_requested = false, m_disarmed = false;
    std::thread m_watcher; ///< last, so that it starts when all else is there
};

} // namespace esm
