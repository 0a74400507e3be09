#include "app/editor/preview/safe_step_finder.h"

#include "core/dynamics/stability.h"

#include <chrono>

namespace esm {

namespace {

/// A drag edits many times a second: only where it rests is worth the work.
constexpr std::chrono::milliseconds settleTime{300};

constexpr double tolerance = 0.05; ///< enough for a gauge

} // namespace

SafeStepFinder::SafeStepFinder(Found found)
    : m_found(std::move(found)), m_thread(QThread::create([this] { work(); })) {
    m_thread->start(QThread::IdlePriority);
}

SafeStepFinder::~SafeStepFinder() {
    {
        const std::lock_guard lock(m_mutex);
        m_stop = true;
    }
    m_changed.notify_one();
    // Nobody is kept waiting for what idles.
    m_thread->setPriority(QThread::NormalPriority);
    m_thread->wait();
}

void SafeStepFinder::find(TissueModel model, Integrator integrator) {
    {
        const std::lock_guard lock(m_mutex);
        m_waiting = Question{std::move(model), integrator};
    }
    m_changed.notify_one();
}

bool SafeStepFinder::isObsolete() {
    const std::lock_guard lock(m_mutex);
    return m_stop || m_waiting;
}

void SafeStepFinder::work() {
    std::unique_lock lock(m_mutex);
    for (;;) {
        m_changed.wait(lock, [this] { return m_stop || m_waiting; });
        if (m_stop) return;
        const Question question = std::move(*m_waiting);
        m_waiting.reset();
        if (m_changed.wait_for(lock, settleTime, [this] { return m_stop || m_waiting; })) continue;
        lock.unlock();
        try {
            const auto step = criticalStep(question.model, question.integrator,
                                           {tolerance, [this](double) { return !isObsolete(); }});
            if (!isObsolete()) m_found(step);
        } catch (const std::exception&) {
            // Superseded; or the simulation says itself what is wrong with the model.
        }
        lock.lock();
    }
}

} // namespace esm
