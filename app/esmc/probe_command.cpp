#include "app/esmc/arguments.h"
#include "app/esmc/commands.h"
#include "app/esmc/runnable_model.h"
#include "core/exchange/charts/chart_file.h"
#include "core/exchange/charts/press_chart.h"
#include "core/probing/probe.h"
#include "core/support/atomic_file.h"
#include "core/support/errors.h"

namespace esm {

namespace {

struct ProbeOptions {
    std::string model, place, direction, other, table, plot;
    std::optional<int> node;
    double radius = 0.008, depth = 0.004, creepTime = 1;
    int steps = 10;
    std::optional<double> relaxation, creep;
};

CLI::Validator pressChartEnding() {
    const auto check = [](const std::string& file) -> std::string {
        return isChartFile(file) ? "" : "'" + file + "' ends neither in .svg nor in .png";
    };
    return CLI::Validator(check, "");
}

void declareProbe(CLI::App& command, ProbeOptions& options) {
    command.add_option("model", options.model, "Project or model package")->required();
    CLI::Option* const at =
        command.add_option("--at", options.place, "Place on the surface to press: \"x y z\", m");
    command.add_option("--node", options.node, "Node to press, in place of --at")
        ->transform(wholeNumber())
        ->excludes(at);
    command.add_option("--direction", options.direction,
                       "Into the organ: \"x y z\" (without: across its surface)");
    command.add_option("--radius", options.radius, "Of the finger's tip, m (0.008)")->check(positiveNumber());
    command.add_option("--depth", options.depth, "To press to, m (0.004)")->check(positiveNumber());
    command.add_option("--steps", options.steps, "Depths at which the force is measured (10)")
        ->transform(wholeNumber(1, mostProbeSteps));
    command
        .add_option("--relax", options.relaxation,
                    "Also press to the depth within 0.05 s and stay there, for so many s in all")
        ->check(positiveNumber());
    command.add_option("--creep", options.creep, "Also push with so many N from the first moment on")
        ->check(positiveNumber());
    command.add_option("--creep-time", options.creepTime, "For so many s (1)")->check(positiveNumber());
    command.add_option("--with", options.other, "Another project or package, to press at the same place");
    command.add_option("--csv", options.table, "Table of the curves to write (.csv)")
        ->check(writtenAs(".csv"));
    command.add_option("--plot", options.plot, "Chart to draw (.svg or .png)")->check(pressChartEnding());
}

std::optional<Eigen::Vector3d> threeNumbers(const std::string& text, const std::string& option) {
    if (text.empty()) return {};
    const std::vector<double> numbers = parseNumbers(text, option);
    if (numbers.size() != 3) throw UsageError(option + ": three numbers are meant, \"x y z\"");
    return Eigen::Vector3d(numbers[0], numbers[1], numbers[2]);
}

/// All but the place of a node, which the model has to be read for.
ProbeSettings settingsOf(const ProbeOptions& options) {
    if (options.place.empty() && !options.node)
        throw UsageError("say where to press: --at \"x y z\" or --node N");
    ProbeSettings settings;
    settings.place = threeNumbers(options.place, "--at").value_or(Eigen::Vector3d::Zero());
    settings.direction = threeNumbers(options.direction, "--direction");
    settings.radius = options.radius;
    settings.depth = options.depth;
    settings.steps = options.steps;
    if (options.relaxation) settings.relaxation = RelaxationTest{*options.relaxation};
    if (options.creep) settings.creep = CreepTest{*options.creep, options.creepTime};
    return settings;
}

const Eigen::Vector3d& placeOfNode(int node, const TissueModel& model) {
    const auto& nodes = model.network->restPositions;
    if (node < 0 || static_cast<std::size_t>(node) >= nodes.size())
        throw InvalidModel("there is no node " + std::to_string(node) + ": nodes are 0 to " +
                           std::to_string(nodes.size() - 1));
    return nodes[static_cast<std::size_t>(node)];
}

Json timeCurveInJson(const TimeCurve& curve) {
    Json json;
    json["time"] = inJson(curve.timeConstant);
    json["end"] = {{"depth", curve.end.depth}, {"force", curve.end.force}};
    json["curve"] = Json::array();
    for (const auto& [time, depth, force] : curve.points)
        json["curve"].push_back({{"time", time}, {"depth", depth}, {"force", force}});
    return json;
}

Json probeInJson(const ProbeResult& result, double radius) {
    Json json;
    json["place"] = inJson(result.place);
    json["direction"] = inJson(result.direction);
    json["radius"] = radius;
    json["depth"] = result.curve.back().depth;
    json["force"] = result.curve.back().force;
    json["stiffness_at_start"] = result.stiffnessAtStart;
    json["stiffness"] = result.stiffness;
    json["poissons_ratio"] = result.poissonsRatio;
    json["youngs_modulus"] = result.youngsModulus;
    json["relaxation_time"] = result.relaxation ? inJson(result.relaxation->timeConstant) : Json();
    json["creep_time"] = result.creep ? inJson(result.creep->timeConstant) : Json();
    json["curve"] = Json::array();
    for (const auto& [depth, force] : result.curve)
        json["curve"].push_back({{"depth", depth}, {"force", force}});
    if (result.relaxation) json["relaxation"] = timeCurveInJson(*result.relaxation);
    if (result.creep) json["creep"] = timeCurveInJson(*result.creep);
    return json;
}

std::string timeConstantInText(const std::string& what, const TimeCurve& curve) {
    if (!curve.timeConstant) return what + ": not within the test, or next to none";
    return what + ": " + inText(*curve.timeConstant) + " s until 1/e of the way is left";
}

std::vector<std::string> probeInText(const ProbeResult& result) {
    const PressPoint& full = result.curve.back();
    std::vector<std::string> text;
    text.push_back(inText(full.force) + " N at " + inText(1000 * full.depth) + " mm, pressed at " +
                   inText(result.place) + " m");
    text.push_back("stiffness " + inText(result.stiffnessAtStart / 1000) + " N/mm at the start, " +
                   inText(result.stiffness / 1000) + " N/mm at full depth");
    text.push_back("resists as a wide, deep solid of " + inText(result.youngsModulus / 1000) +
                   " kPa would, at Poisson's ratio " + inText(result.poissonsRatio));
    if (result.relaxation) text.push_back(timeConstantInText("relaxation", *result.relaxation));
    if (result.creep)
        text.push_back(timeConstantInText("creep", *result.creep) + ", to " +
                       inText(1000 * result.creep->end.depth) + " mm");
    return text;
}

void warnOfFixed(const ProbeResult& result, const std::string& file, std::vector<std::string>& warnings) {
    if (result.meetsFixed)
        warnings.push_back(file + ": the finger also lies on fixed nodes, whose force is not counted");
}

Report runProbe(const ProbeOptions& options, Context& context) {
    ProbeSettings settings = settingsOf(options);
    for (const std::string& file : {options.table, options.plot})
        if (!file.empty()) AtomicFile{file}; // refused now rather than after the work
    const RunnableModel model = loadRunnableModel(options.model, "", context);
    if (options.node) settings.place = placeOfNode(*options.node, model.tissue);
    const ProbeResult result =
        probe({model.tissue, model.surface}, settings, progressOf(context, "pressing"));
    Report report;
    report.json = probeInJson(result, settings.radius);
    report.text = probeInText(result);
    std::vector<std::string> warnings;
    warnOfFixed(result, options.model, warnings);
    std::vector<NamedPress> presses{{std::filesystem::path(options.model).stem().string(), result.curve}};
    if (!options.other.empty()) {
        const RunnableModel other = loadRunnableModel(options.other, "", context);
        const ProbeResult there =
            probe({other.tissue, other.surface}, settings, progressOf(context, "pressing the other"));
        report.json["with"] = probeInJson(there, settings.radius);
        report.text.push_back(options.other + ":");
        for (std::string& line : probeInText(there))
            report.text.push_back(std::move(line));
        warnOfFixed(there, options.other, warnings);
        presses.push_back({std::filesystem::path(options.other).stem().string(), there.curve});
    }
    if (!options.plot.empty()) {
        writeChart(pressChart(presses), options.plot);
        addWritten(report, options.plot);
    }
    if (!options.table.empty()) {
        writeFileAtomically(options.table, pressCsv(presses));
        addWritten(report, options.table);
    }
    addWarnings(report, warnings);
    return report;
}

} // namespace

void addProbeCommand(CLI::App& app, Context& context) {
    addCommand(app, context,
               Command<ProbeOptions>{"probe", "Press a finger into an organ: force over depth, modulus",
                                     declareProbe, runProbe});
}

} // namespace esm
