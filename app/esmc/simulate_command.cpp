#include "app/esmc/arguments.h"
#include "app/esmc/commands.h"
#include "app/esmc/model_report.h"
#include "app/esmc/trajectory_file.h"
#include "core/dynamics/scene_run.h"
#include "core/exchange/project_file.h"
#include "core/exchange/scene_file.h"

#include <cmath>
#include <numeric>

namespace esm {

namespace {

struct SimulateOptions {
    std::string model, scene, output;
    std::string integrator = "auto", timeStep = "auto", precision = "double", damping = "isotropic";
};

void declareSimulate(CLI::App& command, SimulateOptions& options) {
    command.add_option("model", options.model, "Project or model package")->required();
    command.add_option("--scene", options.scene, "Scene in place of the project's own (.json)");
    command.add_option("--integrator", options.integrator, "auto (the default), euler, split or split2");
    command.add_option("--dt", options.timeStep,
                       "Time step, s, taken as given; auto (the default) chooses a safe one");
    command.add_option("--precision", options.precision, "double");
    command.add_option("--damping", options.damping, "isotropic (the default) or axial")
        ->check(oneOf({"isotropic", "axial"}));
    command.add_option("-o,--output", options.output, "Trajectory to write (.csv): time,node,x,y,z")
        ->required()
        ->check(writtenAs(".csv"));
}

SimulationSettings requestedSettings(const SimulateOptions& options) {
    SimulationSettings settings;
    const auto integrator = integratorFromName(options.integrator);
    if (!integrator)
        throw UsageError("--integrator: '" + options.integrator +
                         "' is not one of those there are: auto, euler, split, split2");
    settings.integrator = *integrator;
    if (options.precision != "double")
        throw UsageError("--precision: '" + options.precision + "' is not offered; there is double");
    if (options.timeStep != "auto") {
        const std::vector<double> step = parseNumbers(options.timeStep, "--dt");
        if (step.size() != 1 || !(step[0] > 0))
            throw UsageError("--dt: give one number of seconds above zero, or auto");
        settings.timeStep = step[0];
    }
    settings.damping = options.damping == "axial" ? Damping::Axial : Damping::Isotropic;
    const bool isSplit =
        settings.integrator == Integrator::Split || settings.integrator == Integrator::Split2;
    if (isSplit && settings.damping == Damping::Axial)
        throw UsageError("--damping axial: " + options.integrator +
                         " needs isotropic damping; take --integrator euler");
    return settings;
}

/// What a run needs of a project or a package.
struct RunnableModel {
    TissueModel tissue;
    std::vector<Triangle> surface;
    Scene scene;
};

/// @throws InvalidModel
void requireValid(const Scene& scene, const SpringNetwork& network) {
    if (auto problems = validate(scene, network.restPositions.size()); !problems.empty())
        throw InvalidModel(std::move(problems));
}

RunnableModel fromProject(const std::filesystem::path& file, const std::optional<Scene>& scene) {
    const Project project = loadProject(file);
    RunnableModel model{{}, simulatedSurface(*project.mesh, *project.network), scene.value_or(project.scene)};
    requireValid(model.scene, *project.network);
    model.tissue = evaluateModel(project, model.scene);
    return model;
}

/// A package holds tethers and fixed nodes as numbers; those of a scene take their place.
RunnableModel fromPackage(const std::filesystem::path& file, const std::optional<Scene>& scene) {
    ModelPackage package = loadPackage(file);
    RunnableModel model{std::move(package.tissue), {}, scene.value_or(Scene())};
    model.surface = simulatedSurface(package.mesh, *model.tissue.network);
    if (!scene) return model;
    requireValid(*scene, *model.tissue.network);
    Project bare;
    bare.network = model.tissue.network;
    const TissueModel held = evaluateModel(bare, *scene);
    model.tissue.tethers = held.tethers;
    model.tissue.fixedNodes = held.fixedNodes;
    return model;
}

std::vector<std::uint32_t> recordedNodes(const Scene& scene, std::size_t nodeCount) {
    if (scene.record.nodes) return *scene.record.nodes;
    std::vector<std::uint32_t> all(nodeCount);
    std::iota(all.begin(), all.end(), 0U);
    return all;
}

/// Nothing for a run without a step, which has no speed.
std::string realTimeInWords(double factor) {
    return std::isfinite(factor) ? ", " + inText(factor) + " times real time" : "";
}

Report describe(const SceneOutcome& outcome) {
    const double realTimeFactor = outcome.simulatedSeconds / outcome.wallSeconds;
    Report report;
    report.json = {{"integrator", integratorName(outcome.integrator)},
                   {"dt", outcome.timeStep},
                   {"steps", outcome.steps},
                   {"wall_s", outcome.wallSeconds},
                   {"setup_s", outcome.setupSeconds},
                   {"simulated_s", outcome.simulatedSeconds},
                   {"real_time_factor", inJson(realTimeFactor)},
                   {"stable", outcome.stable},
                   {"outcome", outcome.outcome},
                   {"active_fraction", 1.0},
                   {"energy", {{"kinetic", outcome.energy.kinetic}, {"elastic", outcome.energy.elastic}}}};
    report.text = {outcome.outcome + ": " + inText(outcome.simulatedSeconds) + " s in " +
                       counted(outcome.steps, "step") + " of " + inText(outcome.timeStep) + " s, " +
                       integratorName(outcome.integrator),
                   inText(outcome.wallSeconds) + " s of computing" + realTimeInWords(realTimeFactor),
                   "energy at the end: kinetic " + inText(outcome.energy.kinetic) + " J, elastic " +
                       inText(outcome.energy.elastic) + " J"};
    if (!outcome.stable) report.failure = "the run stopped: " + outcome.outcome;
    return report;
}

/// What of the scene had no effect on the run.
std::vector<std::string> warningsOf(const RunnableModel& model, const SceneOutcome& outcome) {
    std::vector<std::string> warnings = sceneWarnings(model.scene, model.tissue);
    if (model.scene.instrument && outcome.stable && !outcome.touched)
        warnings.emplace_back(model.tissue.fixedNodes.empty()
                                  ? "the instrument never touches the organ"
                                  : "the instrument never touches the organ where it can move");
    return warnings;
}

Report runSimulate(const SimulateOptions& options, Context& context) {
    const SimulationSettings settings = requestedSettings(options);
    context.subject = options.scene.empty() ? options.model : options.scene;
    const bool isPackage = isModelPackage(options.model);
    std::optional<Scene> scene;
    if (!options.scene.empty()) scene = readSceneFile(options.scene);
    const RunnableModel model =
        isPackage ? fromPackage(options.model, scene) : fromProject(options.model, scene);
    context.subject = options.model;
    TrajectoryFile trajectory(options.output, recordedNodes(model.scene, model.tissue.mass.size()));
    const auto sink = [&trajectory](double time, const std::vector<Eigen::Vector3d>& positions) {
        trajectory.add(time, positions);
    };
    const SceneOutcome outcome = runScene({model.tissue, model.surface, model.scene, settings}, sink,
                                          progressOf(context, "simulating"));
    trajectory.commit();
    Report report = describe(outcome);
    addWarnings(report, warningsOf(model, outcome));
    addWritten(report, options.output);
    return report;
}

} // namespace

void addSimulateCommand(CLI::App& app, Context& context) {
    addCommand(app, context,
               Command<SimulateOptions>{"simulate", "Run a scene and write where the nodes went",
                                        declareSimulate, runSimulate});
}

} // namespace esm
