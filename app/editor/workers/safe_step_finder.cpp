#include "app/editor/workers/safe_step_finder.h"

#include "core/dynamics/stability/stability.h"

#include <chrono>

namespace esm {

namespace {

/// Nobody reads a gauge while a slider is dragged, and the tissue that moves meanwhile needs the processors.
constexpr std::chrono::milliseconds settleTime{250};
constexpr int niceness = 10;

constexpr double tolerance = 0.05; ///< enough for a gauge

} // namespace

SafeStepFinder::SafeStepFinder(Found found)
    : m_found(std::move(found)),
      m_worker([](const auto& task) { return stepOf(task.question, task.progress()); }, [this] { tell(); },
               {niceness, settleTime}) {}

std::optional<double> SafeStepFinder::stepOf(const Question& question, const Progress& progress) {
    return criticalStep(question.model, question.integrator, {tolerance, Deformation::Any, progress});
}

void SafeStepFinder::find(TissueModel model, Integrator integrator) {
    const std::lock_guard lock(m_telling);
    m_latest = m_worker.ask({std::move(model), integrator});
    m_found(std::nullopt);
}

/// Of a failure the simulation says itself what is wrong with the model.
void SafeStepFinder::tell() {
    const std::lock_guard lock(m_telling);
    const Outcome<std::optional<double>> outcome = m_worker.outcome();
    if (outcome.number == m_latest && outcome.failure.empty()) m_found(outcome.answer);
}

} // namespace esm
