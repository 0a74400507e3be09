#include "app/esmc/arguments.h"
#include "app/esmc/commands.h"
#include "app/esmc/critical_steps.h"
#include "app/esmc/runnable_model.h"

#include <algorithm>

namespace esm {

namespace {

struct StabilityOptions {
    std::string model, scene;
    Damping damping = Damping::Isotropic;
};

void declareStability(CLI::App& command, StabilityOptions& options) {
    command.add_option("model", options.model, "Project or model package")->required();
    command.add_option("--scene", options.scene, "Scene in place of the project's own (.json)");
    addDampingOption(command, options.damping);
}

Report runStability(const StabilityOptions& options, Context& context) {
    const RunnableModel model = loadRunnableModel(options.model, options.scene, context);
    const Progress progress = progressOf(context, "looking for the largest stable steps");
    const CriticalSteps atRest =
        criticalSteps(model.tissue, options.damping, {1e-3, Deformation::AtRest, progress});
    CriticalSteps any = criticalSteps(model.tissue, options.damping, {1e-3, Deformation::Any, progress});
    // Both are found within a tolerance; no step is stable at any deformation that is not so at rest.
    for (auto& [integrator, step] : any)
        if (step && atRest.at(integrator)) step = std::min(*step, *atRest.at(integrator));
    Report report;
    const double frequency = largestAngularFrequency(model.tissue);
    report.json["omega_max"] = frequency;
    report.json["critical_dt"] = stepsInJson(atRest);
    report.json["critical_dt_any_deformation"] = stepsInJson(any);
    report.text.push_back("fastest oscillation at rest: " + inText(frequency) + " rad/s");
    report.text.emplace_back("largest stable step at rest, and at any deformation:");
    for (const auto& [integrator, step] : atRest)
        report.text.push_back(std::string("  ") + integratorName(integrator) + ": " + stepInText(step) +
                              ", " + stepInText(any.at(integrator)));
    addWarnings(report, model.warnings);
    return report;
}

} // namespace

void addStabilityCommand(CLI::App& app, Context& context) {
    addCommand(app, context,
               Command<StabilityOptions>{"stability", "Predict the largest stable step of every integrator",
                                         declareStability, runStability});
}

} // namespace esm
