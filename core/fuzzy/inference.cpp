#include "core/fuzzy/inference.h"

#include "core/fuzzy/inference_steps.h"
#include "core/support/errors.h"
#include "core/support/joined.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace esm {

namespace {

std::vector<double> firingDegrees(const FuzzySystem& system,
                                  const std::vector<std::optional<double>>& inputs) {
    std::vector<double> degrees;
    degrees.reserve(system.rules.size());
    for (const FuzzyRule& rule : system.rules)
        degrees.push_back(firingOf(rule, degreeOf(rule.condition, system, inputs)));
    return degrees;
}

} // namespace

/// Mamdani's inference (Mamdani and Assilian 1975) [R 2.48, 2.49]: each rule cuts its conclusions' sets down
/// to its degree, all sets of an output are joined, and the centre of gravity of the whole is its value.
/// Every rule that fires has a say in it. The place of the highest degree, which is often taken instead,
/// would jump from one term to the next while an input moves slowly.
///
/// Time goes with the words of all rules, and for each output with its sets times the places where they bend.
/// Outputs are computed one after another in the same memory.
InferenceResult infer(const FuzzySystem& system, const std::vector<std::optional<double>>& inputs) {
    InferenceResult result;
    result.firing = firingDegrees(system, inputs);
    result.outputs.reserve(system.outputs.size());
    OutputSets work = workingMemory(system);
    for (std::size_t output = 0; output < system.outputs.size(); ++output) {
        collectSets(work, system, output, result.firing);
        result.outputs.push_back(centreOfGravity(system.outputs[output], system.norms.aggregation, work));
    }
    return result;
}

/// Everything that is wrong is gathered, so that a command line or a script is mended once.
std::vector<std::optional<double>> orderedInputs(const FuzzySystem& system, const NamedValues& values) {
    std::vector<std::optional<double>> ordered(system.inputs.size());
    std::vector<std::string> problems;
    for (const auto& [name, value] : values) {
        const auto input = std::find_if(system.inputs.begin(), system.inputs.end(),
                                        [&name = name](const FuzzyVariable& v) { return v.name == name; });
        if (input == system.inputs.end())
            problems.push_back("there is no input \"" + name + "\"; the inputs are " +
                               joinedNames(system.inputs));
        else if (!std::isfinite(value))
            problems.push_back("the input " + name + " is not a finite number");
        else
            ordered[static_cast<std::size_t>(input - system.inputs.begin())] = value;
    }
    if (!problems.empty()) throw InvalidModel(problems);
    return ordered;
}

/// Two decimals are told, so that what would be 0.00 is left out: below 0.005. Of equal degrees the term that
/// stands first in the partition is named first.
std::string inWords(const FuzzyVariable& variable, double value) {
    std::vector<std::pair<double, const std::string*>> degrees;
    for (const FuzzyTerm& term : variable.terms)
        if (const double degree = membership(term.set, value); degree >= 0.005)
            degrees.emplace_back(degree, &term.name);
    std::stable_sort(degrees.begin(), degrees.end(),
                     [](const auto& p, const auto& q) { return p.first > q.first; });
    std::string words;
    for (const auto& [degree, name] : degrees) {
        char number[16];
        std::snprintf(number, sizeof number, "%.2f", degree);
        if (!words.empty()) words += ", ";
        words.append(*name).append(" ").append(number);
    }
    return words.empty() ? "none" : words;
}

} // namespace esm
