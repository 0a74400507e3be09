#include "app/esmc/arguments.h"
#include "app/esmc/commands.h"
#include "core/exchange/fuzzy/fuzzy_file.h"
#include "core/fuzzy/rule_text.h"
#include "core/fuzzy/system_warnings.h"
#include "core/support/file_io.h"

namespace esm {

namespace {

struct EvalOptions {
    std::string system;
    std::vector<std::string> values;
};

void declareEval(CLI::App& command, EvalOptions& options) {
    command
        .add_option("system", options.system, "Fuzzy system: a file (.json, .fcl, .fll), or a preset's name")
        ->required();
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

/// "consistency, 0 to 12: very_soft, soft, medium"
std::string inputText(const FuzzyVariable& input) {
    return input.name + ", " + inText(input.minimum) + " to " + inText(input.maximum) + ": " +
           joinedNames(input.terms);
}

/// For people those that were left out, so that they see what may be said.
void addInputs(Report& report, const FuzzySystem& system, const std::vector<std::optional<double>>& values) {
    Json json = Json::object();
    for (std::size_t i = 0; i < system.inputs.size(); ++i) {
        const FuzzyVariable& input = system.inputs[i];
        Json terms = Json::array();
        for (const FuzzyTerm& term : input.terms)
            terms.push_back(term.name);
        json[input.name] = {{"range", {input.minimum, input.maximum}},
                            {"terms", std::move(terms)},
                            {"value", inJson(values[i])}};
        if (!values[i]) report.text.push_back("input left out: " + inputText(input));
    }
    report.json["inputs"] = std::move(json);
}

Report runEval(const EvalOptions& options, Context& context) {
    const NamedWords words = parseNamedWords(options.values, "--set");
    context.subject = options.system;
    const ImportedFuzzySystem imported = findFuzzySystem(options.system);
    const FuzzySystem& system = imported.system;
    const auto inputs = orderedInputs(system, inputsFor(system, words, "--set"));
    const InferenceResult result = infer(system, inputs);
    Report report;
    addOutputs(report, system, result);
    report.json["firing"] = result.firing;
    for (std::size_t i = 0; i < result.firing.size(); ++i)
        if (result.firing[i] > 0)
            report.text.push_back(inText(result.firing[i]) + "  " + ruleText(system, system.rules[i]));
    addInputs(report, system, inputs);
    std::vector<std::string> warnings = inputWarnings(system, inputs);
    for (const SystemWarning& warning : systemWarnings(system))
        if (bearsOnResults(warning)) warnings.push_back(warning.text);
    warnings.insert(warnings.begin(), imported.warnings.begin(), imported.warnings.end());
    addWarnings(report, warnings);
    return report;
}

struct ConvertOptions {
    std::string from, to;
};

void declareConvert(CLI::App& command, ConvertOptions& options) {
    command.add_option("from", options.from, "Fuzzy system: a file (.json, .fcl, .fll), or a preset's name")
        ->required();
    command.add_option("to", options.to, "File to write (.json, .fcl, .fll)")
        ->required()
        ->check(CLI::Validator(
            [](const std::string& file) {
                return isFuzzyFileName(file) ? std::string()
                                             : "'" + file + "' does not end in .json, .fcl or .fll";
            },
            ""));
}

Report runConvert(const ConvertOptions& options, Context& context) {
    context.subject = options.from;
    ImportedFuzzySystem imported = findFuzzySystem(options.from);
    const FuzzySystem& system = imported.system;
    const ExportedFuzzySystem exported = exportFuzzySystem(system, options.to);
    writeFileAtomically(options.to, exported.text);
    const std::size_t domains = system.inputs.size() + system.outputs.size();
    Report report;
    report.json["rules"] = system.rules.size();
    report.json["domains"] = domains;
    report.text.push_back(system.name + ": " + counted(system.rules.size(), "rule") + ", " +
                          counted(domains, "domain"));
    imported.warnings.insert(imported.warnings.end(), exported.warnings.begin(), exported.warnings.end());
    addWarnings(report, imported.warnings);
    addWritten(report, options.to);
    return report;
}

} // namespace

void addFuzzyCommands(CLI::App& app, Context& context) {
    CLI::App* fuzzy = app.add_subcommand("fuzzy", "Fuzzy systems: words to parameters");
    fuzzy->require_subcommand(1);
    addCommand(*fuzzy, context,
               Command<EvalOptions>{"eval", "Infer the outputs of a fuzzy system", declareEval, runEval});
    addCommand(*fuzzy, context,
               Command<ConvertOptions>{"convert",
                                       "Write a fuzzy system in another language: JSON, FCL or FLL",
                                       declareConvert, runConvert});
}

} // namespace esm
