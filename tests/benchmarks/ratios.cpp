#include "tests/benchmarks/ratios.h"

#include <algorithm>
#include <cstdio>
#include <memory>

namespace benchmarks {

void registerWork(const std::string& name, int repetitions,
                  const std::function<std::function<void()>()>& prepare) {
    constexpr double shortestRun = 0.02; // s, of one repetition
    const auto work = std::make_shared<std::function<void()>>();
    benchmark::RegisterBenchmark(name.c_str(),
                                 [prepare, work](benchmark::State& state) {
                                     if (!*work) *work = prepare();
                                     for (auto _ : state)
                                         (*work)();
                                 })
        ->UseRealTime()
        ->MinTime(shortestRun)
        ->Repetitions(repetitions);
}

bool RatioReporter::ReportContext(const Context&) {
    return true;
}

void RatioReporter::ReportRuns(const std::vector<Run>& runs) {
    for (const Run& run : runs) {
        if (run.run_type != Run::RT_Iteration || run.iterations == 0) continue;
        Repetitions& repetitions = m_repetitions[run.run_name.function_name];
        const auto iterations = static_cast<double>(run.iterations);
        repetitions.thread.push_back(run.cpu_accumulated_time / iterations);
        repetitions.wall.push_back(run.real_accumulated_time / iterations);
    }
}

RatioReporter::Times RatioReporter::timesOf(const std::string& name, Clock clock) const {
    const auto found = m_repetitions.find(name);
    if (found == m_repetitions.end()) return {0, 0};
    std::vector<double> times = clock == Clock::Thread ? found->second.thread : found->second.wall;
    std::sort(times.begin(), times.end());
    return {times[times.size() / 2], times.front()};
}

void RatioReporter::print(const std::vector<Ratio>& ratios) const {
    std::printf("%-46s %10s %10s\n", "µs that one step or pass takes", "median", "best");
    for (const auto& entry : m_repetitions) {
        const Times times = timesOf(entry.first, Clock::Wall);
        std::printf("%-46s %10.2f %10.2f\n", entry.first.c_str(), 1e6 * times.median, 1e6 * times.best);
    }
    std::printf("\n%-45s %10s %10s   %s\n", "ratio", "median", "best", "aim");
    for (const Ratio& ratio : ratios)
        print(ratio);
}

void RatioReporter::print(const Ratio& ratio) const {
    const Times numerator = timesOf(ratio.numerator, ratio.clock);
    const Times denominator = timesOf(ratio.denominator, ratio.clock);
    if (numerator.best == 0 || denominator.best == 0) return;
    if (ratio.measured)
        print(ratio, {*ratio.measured, *ratio.measured});
    else
        print(ratio, {ratio.scale * numerator.median / denominator.median,
                      ratio.scale * numerator.best / denominator.best});
}

void RatioReporter::print(const Ratio& ratio, const Times& value) {
    std::printf("%-45s %10.3f %10.3f   ", ratio.what.c_str(), value.median, value.best);
    if (ratio.least > 0) std::printf("≥ %.2f%s", ratio.least, value.median < ratio.least ? "  missed" : "");
    if (ratio.most > 0) std::printf("≤ %.2f%s", ratio.most, value.median > ratio.most ? "  missed" : "");
    std::printf("\n");
}

} // namespace benchmarks
