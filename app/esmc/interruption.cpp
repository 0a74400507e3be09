#include "app/esmc/interruption.h"

#include <chrono>
#include <csignal>
#include <string_view>
#include <thread>
#include <unistd.h>

namespace esm {

namespace {

sigset_t stopSignals() {
    sigset_t signals;
    sigemptyset(&signals);
    sigaddset(&signals, SIGINT);
    sigaddset(&signals, SIGTERM);
    return signals;
}

} // namespace

Interruption::Interruption() {
    const sigset_t signals = stopSignals();
    pthread_sigmask(SIG_BLOCK, &signals, nullptr);
    std::thread([this] { watch(); }).detach();
}

void Interruption::watch() {
    const sigset_t signals = stopSignals();
    int received = 0;
    sigwait(&signals, &received);
    m_requested = true;
    std::this_thread::sleep_for(std::chrono::milliseconds(500));
    constexpr std::string_view message = "esmc: stopped; nothing was written\n";
    [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, message.data(), message.size());
    ::_exit(1);
}

} // namespace esm
