#include "app/esmc/arguments.h"
#include "app/esmc/commands.h"
#include "app/esmc/integrator_warnings.h"
#include "app/esmc/project_output.h"
#include "app/esmc/runnable_model.h"
#include "core/authoring/accuracy.h"
#include "core/authoring/coarser_runs.h"
#include "core/exchange/charts/chart_file.h"
#include "core/exchange/charts/measured_runs_csv.h"
#include "core/exchange/charts/tradeoff_chart.h"
#include "core/exchange/model_package.h"
#include "core/exchange/project/project_file.h"
#include "core/model/gentle_pull.h"
#include "core/support/atomic_file.h"

#include <algorithm>
#include <set>

namespace esm {

namespace {

/// Which of the recommended runs is saved.
enum class Wish { MaxError, RealTime };

struct TradeoffCommandOptions {
    std::string model, scene, plot, table, output;
    double mostError = 0.01, realTimeFactor = 1, mostSeconds = 10;
    Damping damping = Damping::Isotropic;
    Wish saved = Wish::MaxError;
};

void declareTradeoff(CLI::App& command, TradeoffCommandOptions& options) {
    command.add_option("model", options.model, "Project or model package")->required();
    command.add_option("--scene", options.scene, "Scene in place of the project's own (.json)");
    command
        .add_option("--max-error", options.mostError, "Error wanted at most, relative to the motion (0.01)")
        ->check(numberWithin(leastWish, mostWish));
    command.add_option("--real-time", options.realTimeFactor, "Times real time wanted at least (1)")
        ->check(numberWithin(leastWish, mostWish));
    command
        .add_option("--max-seconds", options.mostSeconds, "What would compute for longer is left out, s (10)")
        ->check(positiveNumber());
    command.add_option("--plot", options.plot, "Chart to draw (.svg or .png)")->check(writtenAsChart());
    command.add_option("--csv", options.table, "Table of all runs to write (.csv)")->check(writtenAs(".csv"));
    addDampingOption(command, options.damping);
    command
        .add_option("-o,--output", options.output,
                    "Project to write with the recommended way to step; may be the one that is read")
        ->check(writtenAs(".esm"));
    addChoice(
        command, "--save", options.saved, {{"max_error", Wish::MaxError}, {"real_time", Wish::RealTime}},
        "What is saved as recommended: least cost to the error (the default), or least error in real time");
}

/// `detail` is the number of simulated nodes.
Json steppingInJson(const Stepping& stepping, std::size_t detail) {
    return {{"integrator", integratorName(stepping.integrator)},
            {"dt", stepping.timeStep},
            {"precision", wordOf(stepping.precision)},
            {"detail", detail}};
}

Json runInJson(const TradeoffRun& run) {
    Json json = steppingInJson(run.stepping, run.nodes);
    json["stable"] = run.stable;
    json["error"] = run.stable ? inJson(run.error) : Json();
    json["error_is_bound"] = run.isErrorBound;
    json["wall_per_simulated_s"] = inJson(run.wallPerSimulatedSecond);
    json["real_time_factor"] = inJson(run.realTimeFactor());
    return json;
}

std::string wayInText(const Stepping& stepping, std::size_t nodes) {
    return std::string(integratorName(stepping.integrator)) + " in " + wordOf(stepping.precision) +
           ", step " + inText(stepping.timeStep) + " s, " + counted(nodes, "node");
}

std::string leftOutInText(const LeftOutRun& run) {
    return wayInText(run.stepping, run.nodes) + ": " + run.reason;
}

std::string runInText(const TradeoffRun& run) {
    return wayInText(run.stepping, run.nodes) + (run.isErrorBound ? ": error at most " : ": error ") +
           inText(100 * run.error) + " % of the motion, " + inText(run.realTimeFactor()) + " times real time";
}

Json tradeoffInJson(const Tradeoff& tradeoff, std::size_t detail) {
    const auto chosen = [&](const std::optional<std::size_t>& run) {
        return run ? runInJson(tradeoff.runs[*run]) : Json();
    };
    Json json;
    json["reference"] = steppingInJson(tradeoff.reference.stepping, detail);
    json["reference"]["estimated_error"] = tradeoff.reference.estimatedError;
    json["reference"]["hides_swings"] = tradeoff.reference.hidesSwings;
    json["runs"] = json["pareto"] = Json::array();
    for (const TradeoffRun& run : tradeoff.runs)
        json["runs"].push_back(runInJson(run));
    for (const std::size_t i : tradeoff.pareto)
        json["pareto"].push_back(runInJson(tradeoff.runs[i]));
    json["recommended"] = {{"real_time", chosen(tradeoff.bestInRealTime)},
                           {"max_error", chosen(tradeoff.fastestToError)}};
    json["left_out"] = Json::array();
    for (const LeftOutRun& run : tradeoff.leftOut)
        json["left_out"].push_back(leftOutInText(run));
    return json;
}

/// One line for all of an integrator's runs.
void addLeftOut(const std::vector<LeftOutRun>& leftOut, Integrator integrator,
                std::vector<std::string>& text) {
    const auto isOf = [&](const LeftOutRun& run) { return run.stepping.integrator == integrator; };
    const auto first = std::find_if(leftOut.begin(), leftOut.end(), isOf);
    if (first == leftOut.end()) return;
    const auto others = std::count_if(std::next(first), leftOut.end(), isOf);
    text.push_back("left out: " + leftOutInText(*first) +
                   (others ? "; and " + std::to_string(others) + " more" : ""));
}

std::vector<std::string> tradeoffInText(const Tradeoff& tradeoff, const TradeoffCommandOptions& options) {
    std::vector<std::string> text;
    text.reserve(tradeoff.pareto.size());
    for (const std::size_t i : tradeoff.pareto)
        text.push_back(runInText(tradeoff.runs[i]));
    const auto recommend = [&](const std::string& wish, const std::optional<std::size_t>& run) {
        text.push_back(wish + ": " + (run ? runInText(tradeoff.runs[*run]) : "nothing reaches it"));
    };
    recommend("least error in " + inText(options.realTimeFactor) + " times real time",
              tradeoff.bestInRealTime);
    recommend("least time to an error of " + inText(100 * options.mostError) + " %", tradeoff.fastestToError);
    for (const Integrator integrator : allIntegrators)
        addLeftOut(tradeoff.leftOut, integrator, text);
    return text;
}

/// Writes the project with the run that is recommended, on the run's nodes, and with all others.
void saveRecommended(const Tradeoff& tradeoff, const TradeoffCommandOptions& options, const Project& project,
                     const ProjectOutput& output, std::vector<std::string>& warnings, Report& report) {
    const auto& chosen = options.saved == Wish::RealTime ? tradeoff.bestInRealTime : tradeoff.fastestToError;
    if (!chosen) {
        report.failure = "no run reaches what is wanted, and nothing was saved: allow a larger --max-error, "
                         "a lower --real-time or more --max-seconds";
        return;
    }
    const TradeoffRun& run = tradeoff.runs[*chosen];
    output.save(withMeasuredRun(project, *chosen));
    report.json["saved"] = runInJson(run);
    report.text.push_back("recommended from now on: " + runInText(run));
    if (run.coarser)
        warnings.push_back(counted(run.nodes, "node") + " are simulated in place of " +
                           std::to_string(project.network->restPositions.size()) + ": node numbers are new");
    addWritten(report, output.file());
}

/// Before long work, what would keep its result from being saved.
void requireSavable(const TradeoffCommandOptions& options) {
    if (options.damping != Damping::Isotropic)
        throw UsageError("-o: what is recommended holds for isotropic damping; leave --damping out");
    if (isModelPackage(options.model))
        throw UsageError("-o: a model package keeps what it was exported with; measure the project, and "
                         "export it again");
}

void appendWarnings(std::vector<std::string>& warnings, const std::vector<std::string>& more) {
    warnings.insert(warnings.end(), more.begin(), more.end());
}

/// Each once.
std::vector<std::string> integratorWarnings(const Scene& scene, const std::vector<TradeoffRun>& runs) {
    std::set<Integrator> integrators;
    for (const TradeoffRun& run : runs)
        integrators.insert(run.stepping.integrator);
    std::vector<std::string> warnings;
    for (const Integrator integrator : integrators)
        appendWarnings(warnings, integratorWarnings(scene, integrator));
    return warnings;
}

Report runTradeoff(const TradeoffCommandOptions& options, Context& context) {
    if (!options.output.empty()) requireSavable(options);
    std::optional<ProjectOutput> output;
    if (!options.output.empty()) output.emplace(options.output);
    for (const std::string& file : {options.plot, options.table, options.output})
        if (!file.empty()) AtomicFile{file}; // refused now rather than after the work
    RunnableModel model = loadRunnableModel(options.model, options.scene, context);
    requireRecording(model.scene);
    const Scene scene = model.scene;
    std::vector<std::string> warnings;
    if (!movesTissue(model.scene)) {
        model.scene = withGentlePull(model.tissue, model.scene);
        warnings.emplace_back("nothing in the scene moves the organ: a gentle pull at its edge was measured");
    }
    TradeoffOptions wanted;
    wanted.wishes = {options.realTimeFactor, options.mostError};
    wanted.mostSecondsPerRun = options.mostSeconds;
    wanted.damping = options.damping;
    wanted.threads = static_cast<std::size_t>(context.threads);
    const Progress progress = progressOf(context, "measuring error and cost");
    if (model.project) wanted.coarser = coarserRuns(*model.project, model.scene, progress);
    const Tradeoff tradeoff = measureTradeoff({model.tissue, model.surface, model.scene}, wanted, progress);
    if (tradeoff.reference.hidesSwings)
        warnings.push_back(
            "no error contains anything of swings that are faster than the reference's steps: " +
            std::string(integratorName(tradeoff.reference.stepping.integrator)) +
            " damps them away; allow more --max-seconds, or give the tissue more viscosity where "
            "it has next to none");
    appendWarnings(warnings, integratorWarnings(model.scene, tradeoff.runs));
    appendWarnings(warnings, model.warnings);
    Report report;
    report.json = tradeoffInJson(tradeoff, model.tissue.mass.size());
    report.text = tradeoffInText(tradeoff, options);
    if (!options.plot.empty()) {
        writeChart(tradeoffChart(tradeoff, wanted.wishes), options.plot);
        addWritten(report, options.plot);
    }
    if (!options.table.empty()) {
        writeFileAtomically(options.table, measuredRunsCsv(tradeoff));
        addWritten(report, options.table);
    }
    if (output)
        saveRecommended(tradeoff, options, withAccuracy(*model.project, scene, tradeoff), *output, warnings,
                        report);
    addWarnings(report, warnings);
    return report;
}

} // namespace

void addTradeoffCommand(CLI::App& app, Context& context) {
    addCommand(app, context,
               Command<TradeoffCommandOptions>{"tradeoff",
                                               "Measure error and cost of every way to step a scene",
                                               declareTradeoff, runTradeoff});
}

} // namespace esm
