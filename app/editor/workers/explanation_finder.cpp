#include "app/editor/workers/explanation_finder.h"

#include <chrono>

namespace esm {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t coarsestMap = 8, finestMap = 64; // cells
/// A finer map is not begun that would take longer.
constexpr std::chrono::seconds mostForMap{20};
constexpr std::chrono::milliseconds soon{10};

/// Whether both ask for the same drawing: it does not depend on the inputs it is drawn over.
bool isSameDrawing(const std::optional<WhyQuestion>& drawn, const WhyQuestion& asked,
                   std::initializer_list<std::size_t> over) {
    if (!drawn || drawn->system != asked.system || drawn->point.output != asked.point.output ||
        drawn->across != asked.across || (over.size() > 1 && drawn->up != asked.up))
        return false;
    std::vector<std::optional<double>> inputs = drawn->point.inputs;
    for (const std::size_t input : over)
        inputs[input] = asked.point.inputs[input];
    return inputs == asked.point.inputs;
}

void explain(const WhyQuestion& question, WhyAnswer& answer) {
    const ResponseQuestion& point = question.point;
    answer.rules = explainRules(*question.system, point.inputs);
    std::vector<double> firing;
    firing.reserve(answer.rules.size());
    for (const RuleExplanation& rule : answer.rules)
        firing.push_back(rule.firing);
    answer.output = explainOutput(*question.system, point.output, firing);
    answer.inputs = point.inputs;
}

} // namespace

ExplanationFinder::ExplanationFinder(QObject* parent)
    : QObject(parent),
      m_worker([this](const Worker::Task& task) { return answerTo(task); }, [this] { emit found(); }) {}

WhyAnswer ExplanationFinder::answer() const {
    const Outcome<WhyAnswer> outcome = m_worker.outcome();
    WhyAnswer answer = outcome.answer;
    answer.complete = outcome.number;
    if (!outcome.failure.empty()) answer.failed = outcome.number;
    answer.failure = QString::fromStdString(outcome.failure);
    return answer;
}

WhyAnswer ExplanationFinder::answerTo(const Worker::Task& task) {
    try {
        explain(task.question, m_known);
        m_known.explained = task.number;
        task.show(m_known);
        drawCurve(task);
        drawMap(task);
    } catch (const Cancelled&) {
        throw;
    } catch (...) {
        // The next question may be simpler, and finds nothing half drawn.
        m_curveOf.reset();
        m_mapOf.reset();
        throw;
    }
    return m_known;
}

void ExplanationFinder::drawCurve(const Worker::Task& task) {
    const WhyQuestion& question = task.question;
    if (!isSameDrawing(m_curveOf, question, {question.across})) {
        m_curveOf.reset();
        m_known.curve = std::make_shared<const ResponseCurve>(
            responseCurve(*question.system, question.point, question.across, task.progress()));
        m_curveOf = question;
    }
    m_known.drawn = task.number;
    task.show(m_known);
}

void ExplanationFinder::drawMap(const Worker::Task& task) {
    const WhyQuestion& question = task.question;
    if (!question.up) return;
    if (isSameDrawing(m_mapOf, question, {question.across, *question.up})) {
        m_known.mapped = task.number;
        return;
    }
    m_mapOf.reset();
    for (std::size_t cells = coarsestMap; cells <= finestMap; cells *= 2) {
        const auto start = Clock::now();
        auto map = std::make_shared<const ResponseMap>(responseMap(
            *question.system, question.point, {question.across, *question.up}, cells, task.progress()));
        const auto took = Clock::now() - start;
        const bool isLast = 2 * cells > finestMap || 4 * took > mostForMap;
        // What is finer soon need not be shown.
        if (isLast || took > soon) {
            m_known.map = std::move(map);
            m_known.mapped = task.number;
            task.show(m_known);
        }
        if (isLast) break;
    }
    m_mapOf = question;
}

} // namespace esm
