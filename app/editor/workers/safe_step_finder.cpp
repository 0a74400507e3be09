#include "app/editor/workers/safe_step_finder.h"

#include "core/dynamics/stability/stability.h"

#include <chrono>

namespace esm {

namespace {

/// Edits that come at once are answered once.
constexpr std::chrono::milliseconds settleTime{10};

constexpr double tolerance = 0.05; ///< enough for a gauge

} // namespace

SafeStepFinder::SafeStepFinder(Found found)
    : m_found(std::move(found)), m_thread(QThread::create([this] { work(); })) {
    m_thread->start(QThread::IdlePriority);
}

SafeStepFinder::~SafeStepFinder() {
    m_questions.stop();
    // Nobody is kept waiting for what idles.
    m_thread->setPriority(QThread::NormalPriority);
    m_thread->wait();
}

void SafeStepFinder::find(TissueModel model, Integrator integrator) {
    const std::lock_guard lock(m_telling);
    m_questions.put({std::move(model), integrator});
    m_found(std::nullopt);
}

void SafeStepFinder::work() {
    while (const auto question = m_questions.take()) {
        if (m_questions.becomesObsoleteWithin(settleTime)) continue;
        try {
            const auto step = criticalStep(
                question->model, question->integrator,
                {tolerance, Deformation::Any, [this](double) { return !m_questions.isObsolete(); }});
            const std::lock_guard lock(m_telling);
            if (!m_questions.isObsolete()) m_found(step);
        } catch (const std::exception&) {
            // Superseded; or the simulation says itself what is wrong with the model.
        }
    }
}

} // namespace esm
