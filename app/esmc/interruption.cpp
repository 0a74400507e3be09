#include "app/esmc/interruption.h"

#include "core/support/errors.h"

#include <chrono>
#include <csignal>
#include <string_view>
#include <unistd.h>

namespace esm {

namespace {

/// Ends the watcher's waiting when nothing came.
constexpr int wakeSignal = SIGUSR1;

sigset_t watchedSignals() {
    sigset_t signals;
    sigemptyset(&signals);
    for (const int signal : {SIGINT, SIGTERM, wakeSignal})
        sigaddset(&signals, signal);
    return signals;
}

} // namespace

Interruption::Interruption() {
    const sigset_t signals = watchedSignals();
    pthread_sigmask(SIG_BLOCK, &signals, nullptr);
    m_watcher = std::thread([this] { watch(); });
}

Interruption::~Interruption() {
    acknowledge();
    pthread_kill(m_watcher.native_handle(), wakeSignal);
    m_watcher.join();
}

bool Interruption::requested() const {
    const std::lock_guard<std::mutex> lock(m_mutex);
    return m_requested;
}

void Interruption::disarm() {
    const std::lock_guard<std::mutex> lock(m_mutex);
    if (m_requested) throw Cancelled();
    m_disarmed = true;
}

void Interruption::acknowledge() {
    {
        const std::lock_guard<std::mutex> lock(m_mutex);
        m_disarmed = true;
    }
    m_disarming.notify_all();
}

void Interruption::watch() {
    const sigset_t signals = watchedSignals();
    std::unique_lock<std::mutex> lock(m_mutex);
    int received = wakeSignal;
    do {
        lock.unlock();
        sigwait(&signals, &received);
        lock.lock();
    } while (received == wakeSignal && !m_disarmed);
    if (m_disarmed) return;
    m_requested = true;
    if (m_disarming.wait_for(lock, std::chrono::milliseconds(500), [this] { return m_disarmed; })) return;
    constexpr std::string_view message = "esmc: stopped; every output is whole or as it was before\n";
    [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, message.data(), message.size());
    ::_exit(1);
}

} // namespace esm
