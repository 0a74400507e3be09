#include "app/esmc/arguments.h"
#include "app/esmc/commands.h"
#include "core/exchange/fuzzy_file.h"
#include "core/fuzzy/rule_text.h"

namespace esm {

namespace {

struct EvalOptions {
    std::string system;
    std::vector<std::string> values;
};

void declareEval(CLI::App& command, EvalOptions& options) {
    command.add_option("system", options.system, "Fuzzy system: a JSON file, or a preset's name")->required();
    command
        .add_option("--set", options.values,
                    "NAME=VALUE of an input, a number or a term's name; repeat it for every input that is "
                    "known")
        ->allow_extra_args(false);
}

std::vector<std::string> inputWarnings(const FuzzySystem& system,
                                       const std::vector<std::optional<double>>& inputs) {
    std::vector<std::string> warnings;
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        const FuzzyVariable& variable = system.inputs[i];
        if (!inputs[i] || (*inputs[i] >= variable.minimum && *inputs[i] <= variable.maximum)) continue;
        warnings.push_back(variable.name + " " + inText(*inputs[i]) + " is outside its range, " +
                           inText(variable.minimum) + " to " + inText(variable.maximum));
    }
    return warnings;
}

void addOutputs(Report& report, const FuzzySystem& system, const InferenceResult& result) {
    Json outputs = Json::object();
    for (std::size_t i = 0; i < system.outputs.size(); ++i) {
        const FuzzyVariable& output = system.outputs[i];
        const std::optional<double>& value = result.outputs[i];
        outputs[output.name] = inJson(value);
        report.text.push_back(
            output.name + " = " +
            (value ? inText(*value) + " (" + inWords(output, *value) + ")" : "no rule fires"));
    }
    report.json["outputs"] = std::move(outputs);
}

Report runEval(const EvalOptions& options, Context& context) {
    const NamedWords words = parseNamedWords(options.values, "--set");
    context.subject = options.system;
    const FuzzySystem system = findFuzzySystem(options.system);
    const auto inputs = orderedInputs(system, inputsFor(system, words, "--set"));
    const InferenceResult result = infer(system, inputs);
    Report report;
    addOutputs(report, system, result);
    report.json["firing"] = result.firing;
    for (std::size_t i = 0; i < result.firing.size(); ++i)
        if (result.firing[i] > 0)
            report.text.push_back(inText(result.firing[i]) + "  " + ruleText(system, system.rules[i]));
    addWarnings(report, inputWarnings(system, inputs));
    return report;
}

} // namespace

void addFuzzyCommands(CLI::App& app, Context& context) {
    CLI::App* fuzzy = app.add_subcommand("fuzzy", "Fuzzy systems: words to parameters");
    fuzzy->require_subcommand(1);
    addCommand(*fuzzy, context,
               Command<EvalOptions>{"eval", "Infer the outputs of a fuzzy system", declareEval, runEval});
}

} // namespace esm
