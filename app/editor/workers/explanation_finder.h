#pragma once

#include "app/editor/workers/latest_worker.h"
#include "core/fuzzy/explanation.h"
#include "core/fuzzy/output_response.h"

#include <QObject>
#include <QString>

#include <memory>

namespace esm {

/// What is to be explained: a system, its inputs, one output of it and the inputs to show it over.
struct WhyQuestion {
    std::shared_ptr<const FuzzySystem> system;
    ResponseQuestion point;
    std::size_t across = 0;
    std::optional<std::size_t> up; ///< of a map; none without one
};

/// What is known so far. The numbers are those of the latest questions that the parts answer.
struct WhyAnswer {
    int explained = 0, drawn = 0, mapped = 0;
    std::vector<std::optional<double>> inputs; ///< that rules and output are explained at
    std::vector<RuleExplanation> rules;
    OutputExplanation output;
    std::shared_ptr<const ResponseCurve> curve;
    std::shared_ptr<const ResponseMap> map; ///< null without one; coarse at first where it takes its time
    int failed = 0;                         ///< the latest question that could not be answered as a whole
    QString failure;
    int complete = 0; ///< of the latest question that is answered as a whole, the map as fine as it will be
};

/// Explains on a thread of its own: at once what the rules come to, then the curve, then the map, coarse and
/// ever finer where that takes its time. A question that comes while it works replaces the one it works on.
class ExplanationFinder : public QObject {
    Q_OBJECT

public:
    explicit ExplanationFinder(QObject* parent = nullptr);

    /// Gives the question's number.
    int ask(const WhyQuestion& question) { return m_worker.ask(question); }
    WhyAnswer answer() const;

signals:
    /// The answer holds more than it did.
    void found();

private:
    using Worker = LatestWorker<WhyQuestion, WhyAnswer>;

    WhyAnswer answerTo(const Worker::Task& task);
    void drawCurve(const Worker::Task& task);
    void drawMap(const Worker::Task& task);

    /// The worker's own: what is known so far, and what the curve and the map were drawn for.
    WhyAnswer m_known;
    std::optional<WhyQuestion> m_curveOf, m_mapOf;
    Worker m_worker;
};

} // namespace esm
