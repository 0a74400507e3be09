#pragma once

#include <benchmark/benchmark.h>

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace benchmarks {

/// Time that one thread was computing, whatever else the machine did; or time that passed.
enum class Clock { Thread, Wall };

/// `scale` · time of `numerator` / time of `denominator`, both benchmarks of the same run.
struct Ratio {
    std::string what;
    std::string numerator, denominator;
    Clock clock;
    double least = 0, most = 0; ///< the aim; 0 where there is none
    double scale = 1;
    std::shared_ptr<const double> measured = nullptr; ///< in place of times, once `numerator` has run
};

/// `prepare` returns what is measured; it is called when it is first needed.
void registerWork(const std::string& name, int repetitions,
                  const std::function<std::function<void()>()>& prepare);

/// Keeps the time of every repetition and prints ratios of them instead of times, which move from machine to
/// machine.
class RatioReporter : public benchmark::BenchmarkReporter {
public:
    bool ReportContext(const Context& context) override;
    void ReportRuns(const std::vector<Run>& runs) override;

    /// The median of the repetitions, and the best, which tells what other programs took away.
    void print(const std::vector<Ratio>& ratios) const;

private:
    struct Times {
        double median, best; ///< s
    };
    struct Repetitions {
        std::vector<double> thread, wall; ///< s
    };
    Times timesOf(const std::string& name, Clock clock) const;
    void print(const Ratio& ratio) const;
    static void print(const Ratio& ratio, const Times& value);

    std::map<std::string, Repetitions> m_repetitions;
};

} // namespace benchmarks
