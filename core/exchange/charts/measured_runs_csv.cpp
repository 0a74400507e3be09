#include "core/exchange/charts/measured_runs_csv.h"

#include <array>
#include <charconv>

namespace esm {

namespace {

/// The shortest digits that read back as the same number.
std::string digitsOf(double value) {
    std::array<char, 32> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
    return {digits.data(), end};
}

const char* answer(bool isSo) {
    return isSo ? "yes" : "no";
}

std::string figuresOf(const TradeoffRun& run) {
    if (!run.stable) return ",,,";
    return digitsOf(run.error) + ',' + answer(run.isErrorBound) + ',' + digitsOf(run.wallPerSimulatedSecond) +
           ',' + digitsOf(run.realTimeFactor());
}

} // namespace

std::string measuredRunsCsv(const Tradeoff& tradeoff) {
    std::string text = "integrator,precision,step_s,nodes,stable,error,error_is_bound,wall_per_simulated_s,"
                       "real_time_factor,unbeaten\n";
    const std::vector<bool> unbeaten = unbeatenRuns(tradeoff);
    for (std::size_t i = 0; i < tradeoff.runs.size(); ++i) {
        const TradeoffRun& run = tradeoff.runs[i];
        text += std::string(integratorName(run.stepping.integrator)) + ',' + wordOf(run.stepping.precision) +
                ',' + digitsOf(run.stepping.timeStep) + ',' + std::to_string(run.nodes) + ',' +
                answer(run.stable) + ',' + figuresOf(run) + ',' + answer(unbeaten[i]) + '\n';
    }
    return text;
}

} // namespace esm
