#include "app/esmc/arguments.h"
#include "app/esmc/commands.h"
#include "app/esmc/virtual_tests.h"
#include "core/exchange/charts/chart_file.h"
#include "core/support/atomic_file.h"
#include "core/support/errors.h"

#include <variant>

namespace esm {

namespace {

struct ProbeOptions {
    std::string model, place, direction, along, other, table, plot;
    std::optional<std::string> strip;
    std::optional<int> node;
    double radius = 0.008, depth = 0.004, creepTime = 1;
    int steps = 10;
    double stretch = StripSettings().stretch;
    std::optional<double> relaxation, creep;
};

using TestSettings = std::variant<ProbeSettings, StripSettings>;

void declareFinger(CLI::App& command, ProbeOptions& options) {
    command.add_option("--direction", options.direction,
                       "Of the finger, into the organ: \"x y z\" (without: across its surface)");
    command.add_option("--radius", options.radius, "Of the finger's tip, m (0.008)")->check(positiveNumber());
    command.add_option("--depth", options.depth, "To press to, m (0.004)")->check(positiveNumber());
    command
        .add_option("--relax", options.relaxation,
                    "Also press to the depth within 0.05 s and stay there, for so many s in all")
        ->check(positiveNumber());
    command.add_option("--creep", options.creep, "Also push with so many N from the first moment on")
        ->check(positiveNumber());
    command.add_option("--creep-time", options.creepTime, "For so many s (1)")->check(positiveNumber());
}

void declareStrip(CLI::App& command, ProbeOptions& options) {
    CLI::Option* const strip = command.add_option(
        "--strip", options.strip, "Cut out a strip and stretch it, rather than press: \"length width\", m");
    for (const char* const ofFinger :
         {"--direction", "--radius", "--depth", "--relax", "--creep", "--creep-time"})
        strip->excludes(command.get_option(ofFinger));
    command
        .add_option("--along", options.along,
                    "Of the strip: \"x y z\" (without: along the surface, as the organ is longest)")
        ->needs(strip);
    command.add_option("--stretch", options.stretch, "Of the strip's length, to stretch it to (0.05)")
        ->check(positiveNumber())
        ->needs(strip);
}

void declareProbe(CLI::App& command, ProbeOptions& options) {
    command.add_option("model", options.model, "Project or model package")->required();
    CLI::Option* const at =
        command.add_option("--at", options.place, "Place on the surface to test: \"x y z\", m");
    command.add_option("--node", options.node, "Node to test, in place of --at")
        ->transform(wholeNumber())
        ->excludes(at);
    declareFinger(command, options);
    declareStrip(command, options);
    command.add_option("--steps", options.steps, "Depths, or stretches, at which the force is measured (10)")
        ->transform(wholeNumber(1, mostProbeSteps));
    command.add_option("--with", options.other, "Another project or package, to test at the same place");
    command.add_option("--csv", options.table, "Table of the curves to write (.csv)")
        ->check(writtenAs(".csv"));
    command.add_option("--plot", options.plot, "Chart to draw (.svg or .png)")->check(writtenAsChart());
}

std::optional<Eigen::Vector3d> threeNumbers(const std::string& text, const std::string& option) {
    if (text.empty()) return {};
    const std::vector<double> numbers = parseNumbers(text, option);
    if (numbers.size() != 3) throw UsageError(option + ": three numbers are meant, \"x y z\"");
    return Eigen::Vector3d(numbers[0], numbers[1], numbers[2]);
}

ProbeSettings fingerOf(const ProbeOptions& options) {
    ProbeSettings settings;
    settings.direction = threeNumbers(options.direction, "--direction");
    settings.radius = options.radius;
    settings.depth = options.depth;
    settings.steps = options.steps;
    if (options.relaxation) settings.relaxation = RelaxationTest{*options.relaxation};
    if (options.creep) settings.creep = CreepTest{*options.creep, options.creepTime};
    return settings;
}

StripSettings stripOf(const ProbeOptions& options) {
    const std::vector<double> numbers = parseNumbers(*options.strip, "--strip");
    if (numbers.size() != 2 || !isPositive(numbers[0]) || !isPositive(numbers[1]))
        throw UsageError("--strip: two numbers above 0 are meant, \"length width\"");
    if (options.stretch > largestStretch) throw UsageError("--stretch: at most 1, to twice the length");
    StripSettings settings;
    settings.along = threeNumbers(options.along, "--along");
    settings.length = numbers[0];
    settings.width = numbers[1];
    settings.stretch = options.stretch;
    settings.steps = options.steps;
    return settings;
}

/// All but the place of a node, which the model has to be read for.
TestSettings settingsOf(const ProbeOptions& options) {
    if (options.place.empty() && !options.node)
        throw UsageError("say where to test: --at \"x y z\" or --node N");
    const Eigen::Vector3d place = threeNumbers(options.place, "--at").value_or(Eigen::Vector3d::Zero());
    TestSettings settings = options.strip ? TestSettings(stripOf(options)) : fingerOf(options);
    std::visit([&](auto& test) { test.place = place; }, settings);
    return settings;
}

const Eigen::Vector3d& placeOfNode(int node, const TissueModel& model) {
    const auto& nodes = model.network->restPositions;
    if (node < 0 || static_cast<std::size_t>(node) >= nodes.size())
        throw InvalidModel("there is no node " + std::to_string(node) + ": nodes are 0 to " +
                           std::to_string(nodes.size() - 1));
    return nodes[static_cast<std::size_t>(node)];
}

/// Of one model and then, at the same place, of another. Curves are kept in this order.
Tested tested(const TestSettings& settings, const RunnableModel& model, const std::string& file,
              const Progress& progress, TestCurves& curves) {
    if (const auto* const press = std::get_if<ProbeSettings>(&settings))
        return pressed(model, file, *press, progress, curves);
    return stretched(model, file, std::get<StripSettings>(settings), progress, curves);
}

void addOther(const Tested& other, const std::string& file, Tested& all) {
    all.json["with"] = other.json;
    all.text.push_back(file + ":");
    all.text.insert(all.text.end(), other.text.begin(), other.text.end());
    all.warnings.insert(all.warnings.end(), other.warnings.begin(), other.warnings.end());
}

Report runProbe(const ProbeOptions& options, Context& context) {
    TestSettings settings = settingsOf(options);
    for (const std::string& file : {options.table, options.plot})
        if (!file.empty()) AtomicFile{file}; // refused now rather than after the work
    const RunnableModel model = loadRunnableModel(options.model, "", context);
    if (options.node)
        std::visit([&](auto& test) { test.place = placeOfNode(*options.node, model.tissue); }, settings);
    TestCurves curves;
    Tested all = tested(settings, model, options.model, progressOf(context, "measuring"), curves);
    if (!options.other.empty()) {
        // Of another net the organ might be longest in another direction.
        if (all.along) std::get<StripSettings>(settings).along = all.along;
        const RunnableModel other = loadRunnableModel(options.other, "", context);
        addOther(tested(settings, other, options.other, progressOf(context, "measuring the other"), curves),
                 options.other, all);
    }
    Report report{std::move(all.json), std::move(all.text), {}};
    if (!options.plot.empty()) {
        writeChart(curves.chart(), options.plot);
        addWritten(report, options.plot);
    }
    if (!options.table.empty()) {
        writeFileAtomically(options.table, curves.table());
        addWritten(report, options.table);
    }
    addWarnings(report, all.warnings);
    return report;
}

} // namespace

void addProbeCommand(CLI::App& app, Context& context) {
    addCommand(app, context,
               Command<ProbeOptions>{"probe",
                                     "Press a finger into an organ, or stretch a strip of it: force, modulus",
                                     declareProbe, runProbe});
}

} // namespace esm
