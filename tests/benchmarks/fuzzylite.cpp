#include "tests/benchmarks/fuzzylite.h"

#include "core/exchange/fuzzy/fuzzy_file.h"
#include "core/fuzzy/inference.h"
#include "tests/support/fuzzylite_engine.h"

#include <array>

namespace benchmarks {

namespace {

constexpr int inferenceRepetitions = 15;
constexpr int resolution = 1000; ///< samples over the range of an output

/// Ways over the inputs' ranges, so that no inference is like the one before it.
std::array<std::vector<double>, 16> inputsOf(const esm::FuzzySystem& system) {
    std::array<std::vector<double>, 16> list;
    for (std::size_t i = 0; i < list.size(); ++i)
        for (std::size_t j = 0; j < system.inputs.size(); ++j) {
            const esm::FuzzyVariable& input = system.inputs[j];
            const double part = static_cast<double>((i * (5 + 2 * j) + 3 * j) % list.size()) / list.size();
            list[i].push_back(input.minimum + part * (input.maximum - input.minimum));
        }
    return list;
}

void registerOurs(const std::string& name, const esm::FuzzySystem& system) {
    registerWork(name, inferenceRepetitions, [system] {
        std::vector<std::vector<std::optional<double>>> inputs;
        for (const std::vector<double>& values : inputsOf(system))
            inputs.emplace_back(values.begin(), values.end());
        return [system, inputs, count = std::size_t{0}]() mutable {
            benchmark::DoNotOptimize(esm::infer(system, inputs[count++ % inputs.size()]));
        };
    });
}

void registerTheirs(const std::string& name, const esm::FuzzySystem& system) {
    registerWork(name, inferenceRepetitions, [system] {
        return [engine = std::make_shared<FuzzyliteEngine>(system, resolution), inputs = inputsOf(system),
                count = std::size_t{0}]() mutable { engine->process(inputs[count++ % inputs.size()]); };
    });
}

} // namespace

std::vector<Ratio> registerFuzzylite() {
    const esm::FuzzySystem mamdani = esm::fuzzyPreset("robo-sim");
    esm::FuzzySystem product = mamdani, bounded = mamdani;
    product.norms = {esm::TNorm::Product, esm::TConorm::ProbabilisticSum, esm::TNorm::Product,
                     esm::TConorm::ProbabilisticSum};
    bounded.norms = {esm::TNorm::BoundedDifference, esm::TConorm::BoundedSum, esm::TNorm::BoundedDifference,
                     esm::TConorm::BoundedSum};
    struct Case {
        const char* name;
        const esm::FuzzySystem& system;
        double least;
    };
    std::vector<Ratio> ratios;
    for (const auto& [name, system, least] :
         {Case{"minimum and maximum", mamdani, 50}, {"products", product, 0}, {"bounded sums", bounded, 0}}) {
        const std::string ours = std::string("inference, ") + name,
                          theirs = std::string("fuzzylite, ") + name;
        registerOurs(ours, system);
        registerTheirs(theirs, system);
        ratios.push_back({theirs + " to inference", theirs, ours, Clock::Thread, least});
    }
    return ratios;
}

} // namespace benchmarks
