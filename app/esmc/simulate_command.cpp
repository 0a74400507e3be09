#include "app/esmc/arguments.h"
#include "app/esmc/commands.h"
#include "app/esmc/integrator_warnings.h"
#include "app/esmc/model_report.h"
#include "app/esmc/run_files.h"
#include "app/esmc/runnable_model.h"
#include "app/esmc/volume_report.h"
#include "core/dynamics/measure/scene_accuracy.h"
#include "core/dynamics/stability/stability.h"
#include "core/dynamics/stability/swings.h"
#include "core/model/tissue_digest.h"
#include "core/support/joined.h"
#include "core/support/numbers.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace esm {

namespace {

struct SimulateOptions {
    std::string model, scene, output, surface, forces;
    std::string integrator, timeStep;
    std::optional<Precision> precision;
    std::optional<double> mostError;
    Damping damping = Damping::Isotropic;
    double restTolerance = 0; // m
};

void declareSimulate(CLI::App& command, SimulateOptions& options) {
    command.add_option("model", options.model, "Project or model package")->required();
    command.add_option("--scene", options.scene, "Scene in place of the project's own (.json)");
    command.add_option("--integrator", options.integrator,
                       "One of " + integratorNames() +
                           "; without, the recommended way to step where one is stored, else auto");
    command.add_option("--dt", options.timeStep,
                       "Time step, s, taken as given; auto (the default) chooses a safe one");
    addChoice(command, "--precision", options.precision,
              Words<std::optional<Precision>>{{"double", Precision::Double}, {"float", Precision::Float}},
              "Numbers that are computed with: double (the default) or, with an explicit integrator, float");
    addDampingOption(command, options.damping);
    command
        .add_option("--rest-tolerance", options.restTolerance,
                    "With an explicit integrator, leave out what rests, up to this far off the whole motion, "
                    "m (0: nothing)")
        ->check(nonNegativeNumber());
    command
        .add_option("--max-error", options.mostError,
                    "Halves the step until the estimated error, relative to the motion, is at most this")
        ->check(numberWithin(leastWish, mostWish));
    command.add_option("-o,--output", options.output, "Trajectory to write (.csv): time,node,x,y,z")
        ->required()
        ->check(writtenAs(".csv"));
    command
        .add_option("--surface", options.surface,
                    "The drawn surface's trajectory to write as well (.csv): time,vertex,x,y,z")
        ->check(writtenAs(".csv"));
    command
        .add_option(
            "--forces", options.forces,
            "The tissue's forces on the instruments to write as well (.csv): time,instrument,fx,fy,fz")
        ->check(writtenAs(".csv"));
}

SimulationSettings requestedSettings(const SimulateOptions& options) {
    SimulationSettings settings;
    const auto integrator = integratorFromName(options.integrator.empty() ? "auto" : options.integrator);
    if (!integrator)
        throw UsageError("--integrator: '" + options.integrator +
                         "' is not one of those there are: " + integratorNames());
    settings.integrator = *integrator;
    if (!options.timeStep.empty() && options.timeStep != "auto") {
        const std::vector<double> step = parseNumbers(options.timeStep, "--dt");
        if (step.size() != 1 || !(step[0] > 0))
            throw UsageError("--dt: give one number of seconds above zero, or auto");
        settings.timeStep = step[0];
    }
    settings.damping = options.damping;
    settings.restTolerance = options.restTolerance;
    settings.precision = options.precision.value_or(Precision::Double);
    if (const auto problems = validate(settings); !problems.empty()) throw UsageError(joined(problems, "; "));
    return settings;
}

/// Nothing for a run without a step, which has no speed.
std::string realTimeInWords(double factor) {
    return std::isfinite(factor) ? ", " + inText(factor) + " times real time" : "";
}

/// Where loads begin, end or turn between two whole steps.
std::string cutsInWords(const SceneOutcome& outcome) {
    std::string words;
    if (outcome.cutSteps > 0)
        words += "; " + std::to_string(outcome.cutSteps) +
                 " of them cut where loads begin, end or turn, down to " + inText(outcome.shortestStep) +
                 " s";
    if (outcome.averagedCorners > 0)
        words += "; at " + std::to_string(outcome.averagedCorners) +
                 " more such times the mean of the load over the step stands in";
    return words;
}

/// What pressed on the instruments, by the rows of --forces.
void addInstruments(Report& report, const Scene& scene, const SceneOutcome& outcome) {
    report.json["instruments"] = Json::array();
    for (std::size_t i = 0; i < scene.instruments.size(); ++i) {
        const InstrumentForce force = forceOn(i, outcome);
        const bool touched = outcome.instruments[i].touched;
        report.json["instruments"].push_back({{"name", nameOf(scene, i)},
                                              {"touched", touched},
                                              {"mean_force", force.mean},
                                              {"peak_force", force.peak}});
        if (touched)
            report.text.push_back(nameOf(scene, i) + ": " + inText(force.mean) + " N on the mean, " +
                                  inText(force.peak) + " N at most");
    }
}

/// What each split made, so that loads can name it.
void addSplits(Report& report, const std::vector<SceneStage>& stages) {
    if (stages.empty()) return;
    report.json["splits"] = Json::array();
    for (const SceneStage& stage : stages) {
        const std::vector<PartedNode>& parted = stage.organ.parted;
        Json nodes = Json::array();
        for (const auto& [node, twin, share] : parted)
            nodes.push_back({{"node", twin}, {"of", node}, {"authored", stage.organ.topology.origin[twin]}});
        report.json["splits"].push_back({{"split", stage.split}, {"time", stage.begin}, {"nodes", nodes}});
        report.text.push_back(sceneEntry("split", stage.split) + " at " + inText(stage.begin) +
                              " s: " + counted(parted.size(), "new node") + ", from " +
                              std::to_string(parted.front().twin) + ", of node " +
                              std::to_string(parted.front().node) + ", on");
    }
}

/// What the outcome itself advises, else what helps in most cases.
std::string withAdvice(const std::string& outcome) {
    const bool advises = outcome.find("shorter step") != std::string::npos;
    return advises ? outcome : outcome + "; take a shorter step or smaller loads, or leave both to auto";
}

Report describe(const SceneOutcome& outcome) {
    const double realTimeFactor = outcome.simulatedSeconds / outcome.wallSeconds;
    Report report;
    report.json = {{"integrator", integratorName(outcome.integrator)},
                   {"dt", outcome.timeStep},
                   {"steps", outcome.steps},
                   {"cut_steps", outcome.cutSteps},
                   {"shortest_dt", outcome.shortestStep},
                   {"averaged_corners", outcome.averagedCorners},
                   {"wall_s", outcome.wallSeconds},
                   {"setup_s", outcome.setupSeconds},
                   {"factorisation_s", outcome.factorisationSeconds},
                   {"simulated_s", outcome.simulatedSeconds},
                   {"real_time_factor", inJson(realTimeFactor)},
                   {"stable", outcome.stable},
                   {"outcome", outcome.outcome},
                   {"active_fraction", outcome.activeFraction},
                   {"energy", {{"kinetic", outcome.energy.kinetic}, {"elastic", outcome.energy.elastic}}}};
    report.text = {outcome.outcome + ": " + inText(outcome.simulatedSeconds) + " s in " +
                       counted(outcome.steps, "step") + " of " + inText(outcome.timeStep) + " s, " +
                       integratorName(outcome.integrator) + cutsInWords(outcome),
                   inText(outcome.wallSeconds) + " s of computing" + realTimeInWords(realTimeFactor),
                   "energy at the end: kinetic " + inText(outcome.energy.kinetic) + " J, elastic " +
                       inText(outcome.energy.elastic) + " J"};
    if (!outcome.stable) report.failure = "the run stopped: " + withAdvice(outcome.outcome);
    return report;
}

/// @param error relative to the motion; infinite where it is not known
std::string errorInText(double error) {
    if (std::isinf(error)) return "the error is not known: no two runs came to their end";
    return "estimated error: " + percentText(error) + " of the motion";
}

/// Of a run to a wanted error.
void addError(Report& report, const AccurateOutcome& accurate, std::vector<std::string>& warnings) {
    report.json["estimated_error"] = inJson(accurate.estimatedError);
    report.json["hides_swings"] = accurate.hidesSwings;
    report.text.push_back(errorInText(accurate.estimatedError));
    if (accurate.hidesSwings)
        warnings.push_back(
            std::string("the estimated error contains nothing of swings that are faster than the steps: ") +
            integratorName(accurate.outcome.integrator) +
            " damps them away, and to follow them would take too many steps; give the tissue "
            "more viscosity where it has next to none, or take the error for a part of the true one");
}

/// Of a run whose way to step was left open.
void addResolvedError(Report& report, const AccurateOutcome& accurate, Precision precision,
                      std::vector<std::string>& warnings) {
    addError(report, accurate, warnings);
    if (accurate.isReached || !accurate.outcome.stable) return;
    if (std::isinf(accurate.estimatedError))
        warnings.emplace_back(
            "how far the motion is off is not known: only the run in the shortest steps came to its "
            "end");
    else
        warnings.push_back(
            "the motion may be off by " + percentText(accurate.estimatedError) + " of itself: " +
            (precision == Precision::Float
                 ? "single precision rounds each step, so that shorter ones gain too little; "
                   "take --precision double"
                 : "shorter steps gained too little, or would take long; --max-error waits for "
                   "them, and tradeoff looks for another way to step"));
}

/// Sums up what a run gave, beside its outcome.
struct MotionSeen {
    std::vector<Eigen::Vector3d> start; ///< m, of the recorded nodes
    double longestWay = 0;              ///< m, of one of them from its start
    double farthestPlace = 0;           ///< m, the largest coordinate

    void add(const std::vector<Eigen::Vector3d>& positions) {
        start.insert(start.end(), positions.begin() + static_cast<std::ptrdiff_t>(start.size()),
                     positions.end());
        for (std::size_t i = 0; i < positions.size(); ++i) {
            longestWay = std::max(longestWay, (positions[i] - start[i]).norm());
            farthestPlace = std::max(farthestPlace, positions[i].cwiseAbs().maxCoeff());
        }
    }
};

/// Single precision tells places apart by no less than its rounding, however they were reached.
bool isSpoiltByRounding(const MotionSeen& motion) {
    constexpr double worthAWord = 0.003; // of the motion
    const double rounding = std::numeric_limits<float>::epsilon() / 2 * motion.farthestPlace;
    return rounding > worthAWord * motion.longestWay;
}

/// What makes the motion less exact than its step promises.
std::vector<std::string> accuracyWarnings(const RunnableModel& model, const SimulationSettings& settings,
                                          const SceneOutcome& outcome, const MotionSeen& motion) {
    std::vector<std::string> warnings;
    if (settings.precision == Precision::Float && isSpoiltByRounding(motion))
        warnings.emplace_back("in single precision so small a motion may be off by percents of itself: "
                              "take --precision double, or measure the error with tradeoff");
    if (outcome.touched() && settings.integrator != Integrator::Auto && orderOf(outcome.integrator) > 1)
        warnings.push_back(
            "while the instrument touches the organ " + std::string(integratorName(outcome.integrator)) +
            " is of the first order alone, and no better than euler or split in as long steps");
    if (hidesSwings(swingBounds(model.tissue, settings.damping), outcome.integrator, outcome.timeStep,
                    model.scene.duration))
        warnings.push_back(
            std::string(integratorName(outcome.integrator)) +
            " damps away swings of the tissue that are faster than its steps; with --max-error, "
            "or with a shorter step, more of them is followed");
    return warnings;
}

/// Of an instrument that gave way to nothing.
std::string untouchedInWords(const Scene& scene, std::size_t instrument, const InstrumentTouch& touch) {
    const std::string words =
        hasPlainInstrument(scene) ? "the instrument" : "the instrument \"" + nameOf(scene, instrument) + "\"";
    return words + (touch.metImmovable
                        ? " never touches the organ where it can move: it passes what is fixed or led, which "
                          "gives no force"
                        : " never touches the organ");
}

/// What of the scene had no effect on the run.
std::vector<std::string> warningsOf(const RunnableModel& model, const SceneOutcome& outcome) {
    std::vector<std::string> warnings = sceneWarnings(model.scene, model.tissue);
    if (outcome.timeStep > model.scene.duration)
        warnings.push_back("the step of " + inText(outcome.timeStep) +
                           " s is longer than the scene, which lasts " + inText(model.scene.duration) +
                           " s: it was cut to that");
    for (std::size_t i = 0; i < model.scene.instruments.size(); ++i)
        if (outcome.stable && !outcome.instruments[i].touched)
            warnings.push_back(untouchedInWords(model.scene, i, outcome.instruments[i]));
    return warnings;
}

/// Whether the line leaves open how to step.
bool takesRecommended(const SimulateOptions& options) {
    return options.integrator.empty() && options.timeStep.empty() && !options.precision &&
           !options.mostError && options.restTolerance == 0 && options.damping == Damping::Isotropic;
}

/// The recommended way to step, where tissue that may have changed since is still stable with it.
SimulationSettings recommendedSettings(const RunnableModel& model, const SimulationSettings& settings,
                                       std::vector<std::string>& warnings) {
    SimulationSettings recommended = steppedAsRecommended(settings, model.tissue, model.stepping);
    const Stepping& stepping = model.stepping->stepping;
    if (!recommended.timeStep)
        warnings.push_back("the recommended step of " + inText(stepping.timeStep) + " s is too long for " +
                           integratorName(stepping.integrator) +
                           " with the tissue as it is now; auto stepped it: measure again with tradeoff");
    else if (isFromOtherTissue(*model.stepping, model.tissue))
        warnings.push_back(
            "the tissue has changed since its step was recommended: the error may be other than " +
            inText(100 * model.stepping->error) + " %; measure again with tradeoff");
    return recommended;
}

void append(std::vector<std::string>& list, const std::vector<std::string>& others) {
    list.insert(list.end(), others.begin(), others.end());
}

bool isLeftToAuto(const SimulationSettings& settings) {
    return settings.integrator == Integrator::Auto && !settings.timeStep;
}

AccurateOutcome runRequested(const SceneRun& run, const std::optional<double>& mostError,
                             const NewFrameSink& newSink, const Progress& progress) {
    if (mostError) return runSceneToError(run, *mostError, newSink, progress);
    if (isLeftToAuto(run.settings)) return runSceneResolved(run, newSink, progress);
    return {runScene(run, newSink(), progress), 0};
}

Report runSimulate(const SimulateOptions& options, Context& context) {
    SimulationSettings settings = requestedSettings(options);
    settings.threads = static_cast<std::size_t>(context.threads);
    const RunOutputs outputs{options.output, options.surface, options.forces};
    requireDistinctFiles(outputs);
    const RunnableModel model = loadRunnableModel(options.model, options.scene, context);
    requireRecording(model.scene);
    requireSurface(outputs, model);
    requireInstruments(outputs, model.scene);
    const std::vector<SceneStage> stages =
        laterStages(authoredTopology(model.mesh, model.tissue.network), model.tissue, model.scene);
    std::vector<std::string> warnings;
    if (model.stepping && takesRecommended(options))
        settings = recommendedSettings(model, settings, warnings);
    else if (model.stepping && options.integrator.empty() && options.timeStep.empty() && !options.mostError)
        warnings.emplace_back("the recommended way to step is for other options than these: auto chose one");
    std::optional<RunFiles> files;
    MotionSeen motion;
    const auto newSink = [&]() -> FrameSink {
        files.emplace(outputs, model, stages);
        motion = {};
        return [&](double time, const std::vector<Eigen::Vector3d>& positions) {
            files->add(time, positions);
            motion.add(positions);
        };
    };
    const AccurateOutcome accurate =
        runRequested({model.tissue, model.surface, model.scene, settings}, options.mostError, newSink,
                     progressOf(context, "simulating"));
    files->commit(accurate.outcome.forces, context.interruption);
    Report report = describe(accurate.outcome);
    addInstruments(report, model.scene, accurate.outcome);
    addVolumes(report, model.tissue, accurate.outcome.fluids);
    addSplits(report, stages);
    if (options.mostError)
        addError(report, accurate, warnings);
    else if (isLeftToAuto(settings))
        addResolvedError(report, accurate, settings.precision, warnings);
    else
        append(warnings, accuracyWarnings(model, settings, accurate.outcome, motion));
    append(warnings, integratorWarnings(model.scene, accurate.outcome.integrator));
    append(warnings, warningsOf(model, accurate.outcome));
    append(warnings, model.warnings);
    addWarnings(report, warnings);
    report.json["files"] = Json::array();
    for (const std::string& file : {options.output, options.surface, options.forces}) {
        if (file.empty()) continue;
        report.json["files"].push_back(file);
        addWritten(report, file);
    }
    return report;
}

} // namespace

void addSimulateCommand(CLI::App& app, Context& context) {
    addCommand(app, context,
               Command<SimulateOptions>{"simulate", "Run a scene and write where the nodes went",
                                        declareSimulate, runSimulate});
}

} // namespace esm
