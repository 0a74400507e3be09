#pragma once

#include <condition_variable>
#include <mutex>
#include <optional>
#include <utility>

namespace esm {

/// Hands inputs to a worker thread. Only the latest waits: what the worker did not take yet is replaced.
template<typename Input> class LatestInput {
public:
    void put(Input input) {
        change([&] { m_waiting = std::move(input); });
    }
    /// The worker is to end.
    void stop() {
        change([&] { m_stopped = true; });
    }

    /// Waits for an input and takes it; none when the worker is to end.
    std::optional<Input> take() {
        std::unique_lock lock(m_mutex);
        m_changed.wait(lock, [this] { return isNew(); });
        if (m_stopped) return std::nullopt;
        return std::exchange(m_waiting, std::nullopt);
    }

    /// Whether the input that was taken last is obsolete: another waits, or the worker is to end.
    bool isObsolete() const {
        return isObsolete([](const Input&) { return true; });
    }
    /// @param replaces whether the input that waits makes the one that was taken obsolete
    template<typename Replaces> bool isObsolete(const Replaces& replaces) const {
        const std::lock_guard lock(m_mutex);
        return m_stopped || (m_waiting && replaces(*m_waiting));
    }
    /// The same, watched for `time`.
    template<typename Duration> bool becomesObsoleteWithin(Duration time) {
        std::unique_lock lock(m_mutex);
        return m_changed.wait_for(lock, time, [this] { return isNew(); });
    }

private:
    bool isNew() const { return m_stopped || m_waiting; }
    template<typename Change> void change(const Change& change) {
        {
            const std::lock_guard lock(m_mutex);
            change();
        }
        m_changed.notify_one();
    }

    mutable std::mutex m_mutex;
    std::condition_variable m_changed;
    std::optional<Input> m_waiting;
    bool m_stopped = false;
};

} // namespace esm
