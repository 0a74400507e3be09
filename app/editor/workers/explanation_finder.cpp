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

} // namespace

ExplanationFinder::ExplanationFinder(QObject* parent) : QObject(parent), m_thread([this] { work(); }) {}

ExplanationFinder::~ExplanationFinder() {
    m_questions.stop();
    m_thread.join();
}

int ExplanationFinder::ask(const WhyQuestion& question) {
    m_questions.put({question, ++m_asked});
    return m_asked;
}

WhyAnswer ExplanationFinder::answer() const {
    const std::lock_guard lock(m_mutex);
    return m_answer;
}

template<typename Change> void ExplanationFinder::tell(const Change& change) {
    {
        const std::lock_guard lock(m_mutex);
        change(m_answer);
    }
    emit found();
}

void ExplanationFinder::work() {
    while (const auto asked = m_questions.take()) {
        try {
            explain(*asked);
            drawCurve(*asked);
            drawMap(*asked);
            tell([&](WhyAnswer& answer) { answer.complete = asked->number; });
        } catch (const Cancelled&) {
            continue; // another question waits
        } catch (const std::bad_alloc&) {
            giveUp(*asked, tr("there is not enough memory for it."));
        } catch (const std::exception& error) {
            giveUp(*asked, QString::fromStdString(error.what()));
        }
    }
}

/// Of this question; the next may be simpler.
void ExplanationFinder::giveUp(const Asked& asked, const QString& reason) {
    m_curveOf.reset();
    m_mapOf.reset();
    tell([&](WhyAnswer& answer) {
        answer.complete = answer.failed = asked.number;
        answer.failure = reason;
    });
}

void ExplanationFinder::explain(const Asked& asked) {
    const auto& system = asked.question.system;
    const ResponseQuestion& point = asked.question.point;
    std::vector<RuleExplanation> rules = explainRules(*system, point.inputs);
    std::vector<double> firing;
    firing.reserve(rules.size());
    for (const RuleExplanation& rule : rules)
        firing.push_back(rule.firing);
    OutputExplanation output = explainOutput(*system, point.output, firing);
    tell([&](WhyAnswer& answer) {
        answer.explained = asked.number;
        answer.inputs = point.inputs;
        answer.rules = std::move(rules);
        answer.output = std::move(output);
    });
}

void ExplanationFinder::drawCurve(const Asked& asked) {
    const WhyQuestion& question = asked.question;
    if (!isSameDrawing(m_curveOf, question, {question.across})) {
        m_curveOf.reset();
        const auto goOn = [&](double) { return !m_questions.isObsolete(); };
        auto curve = std::make_shared<const ResponseCurve>(
            responseCurve(*question.system, question.point, question.across, goOn));
        m_curveOf = question;
        tell([&](WhyAnswer& answer) {
            answer.curve = std::move(curve);
            answer.drawn = asked.number;
        });
        return;
    }
    tell([&](WhyAnswer& answer) { answer.drawn = asked.number; });
}

void ExplanationFinder::drawMap(const Asked& asked) {
    const WhyQuestion& question = asked.question;
    if (!question.up) return;
    if (isSameDrawing(m_mapOf, question, {question.across, *question.up})) {
        tell([&](WhyAnswer& answer) { answer.mapped = asked.number; });
        return;
    }
    m_mapOf.reset();
    const auto goOn = [&](double) { return !m_questions.isObsolete(); };
    for (std::size_t cells = coarsestMap; cells <= finestMap; cells *= 2) {
        const auto start = Clock::now();
        auto map = std::make_shared<const ResponseMap>(
            responseMap(*question.system, question.point, {question.across, *question.up}, cells, goOn));
        const auto took = Clock::now() - start;
        const bool isLast = 2 * cells > finestMap || 4 * took > mostForMap;
        // What is finer soon need not be shown.
        if (isLast || took > soon)
            tell([&](WhyAnswer& answer) {
                answer.map = std::move(map);
                answer.mapped = asked.number;
            });
        if (isLast) break;
    }
    m_mapOf = question;
}

} // namespace esm
