#include "tests/benchmarks/explicit_step.h"
#include "tests/benchmarks/local_poke.h"

#include <string>

int main(int argumentCount, char** argumentValues) {
    // What is compared is measured in turn: a machine that becomes slower meanwhile does so for both.
    std::string interleaved = "--benchmark_enable_random_interleaving=true";
    std::vector<char*> arguments(argumentValues, argumentValues + argumentCount);
    arguments.push_back(interleaved.data());
    int count = static_cast<int>(arguments.size());
    benchmark::Initialize(&count, arguments.data());

    std::vector<benchmarks::Ratio> ratios;
    for (const auto registerSubject : {benchmarks::registerExplicitStep, benchmarks::registerLocalPoke})
        for (benchmarks::Ratio& ratio : registerSubject())
            ratios.push_back(std::move(ratio));
    benchmarks::RatioReporter reporter;
    benchmark::RunSpecifiedBenchmarks(&reporter);
    reporter.print(ratios);
    return 0;
}
