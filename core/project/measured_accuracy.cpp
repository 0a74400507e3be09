#include "core/project/measured_accuracy.h"

#include "core/support/offenders.h"

#include <cmath>

namespace esm {

namespace {

bool hasFigures(const TradeoffRun& run) {
    return run.stable && std::isfinite(run.error) && std::isfinite(run.wallPerSimulatedSecond) &&
           run.wallPerSimulatedSecond > 0;
}

/// How the numbers of a run that are stored may be wrong.
template<class Stepped> std::vector<std::string> steppedProblems(const Stepped& stepped) {
    std::vector<std::string> problems = validate(stepped.stepping);
    for (std::string& problem : fieldProblems(stepped))
        problems.push_back(std::move(problem));
    return problems;
}

void requireDigest(const MeasuredOrgan& organ, std::vector<std::string>& problems) {
    if (!isTissueDigest(organ.tissue))
        problems.emplace_back("the tissue it was measured on must be 16 hexadecimal digits");
}

} // namespace

MeasuredAccuracy measuredAccuracy(MeasuredOrgan organ, const Detail& detail, const Tradeoff& measured) {
    MeasuredAccuracy accuracy{std::move(organ),   detail,        {},
                              measured.reference, measured.runs, measured.leftOut};
    for (TradeoffRun& run : accuracy.runs)
        if (!hasFigures(run)) run = {run.stepping, run.nodes, false, 0, false, 0, run.coarser};
    return accuracy;
}

Tradeoff tradeoffOf(const MeasuredAccuracy& accuracy, const TradeoffWishes& wishes) {
    Tradeoff tradeoff{accuracy.reference, accuracy.runs, {}, {}, {}, accuracy.leftOut};
    recommend(tradeoff, wishes);
    return tradeoff;
}

std::vector<std::string> validate(const MeasuredAccuracy& accuracy) {
    std::vector<std::string> problems;
    requireDigest(accuracy.organ, problems);
    if (accuracy.onFewerNodes) requireDigest(*accuracy.onFewerNodes, problems);
    addUnder(problems, "reference", steppedProblems(accuracy.reference));
    if (accuracy.runs.size() + accuracy.leftOut.size() > mostMeasuredRuns)
        problems.push_back("at most " + std::to_string(mostMeasuredRuns) + " runs are kept");
    for (std::size_t i = 0; i < accuracy.runs.size(); ++i)
        addUnder(problems, "run " + std::to_string(i + 1), steppedProblems(accuracy.runs[i]));
    for (std::size_t i = 0; i < accuracy.leftOut.size(); ++i)
        addUnder(problems, "left out run " + std::to_string(i + 1), steppedProblems(accuracy.leftOut[i]));
    return problems;
}

} // namespace esm
