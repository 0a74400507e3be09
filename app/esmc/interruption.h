#pragma once

#include <atomic>

namespace esm {

/// Ctrl-C and SIGTERM. Work that reports its progress is asked to stop; what does not listen within a moment
/// is ended from outside, which is safe because every output is written atomically. Make one at the start of
/// main(), before any other thread: threads inherit the blocked signals.
class Interruption {
public:
    Interruption();

    bool requested() const { return m_requested; }

private:
    [[noreturn]] void watch();

    std::atomic<bool> m_requested = false;
};

} // namespace esm
