#include "app/esmc/arguments.h"
#include "app/esmc/commands.h"
#include "app/esmc/model_report.h"
#include "app/esmc/opened_file.h"
#include "app/esmc/project_output.h"
#include "core/authoring/scale.h"
#include "core/model/tissue_digest.h"

#include <algorithm>

namespace esm {

namespace {

struct ScaleOptions {
    std::string project, points, output;
    std::optional<double> factor, length;
    KeptByScaling kept = KeptByScaling::Mass;
};

void declareScale(CLI::App& command, ScaleOptions& options) {
    command.add_option("project", options.project, "Project to read (.esm)")->required();
    CLI::Option* const factor =
        command.add_option("--factor", options.factor, "How many times as large")->check(positiveNumber());
    CLI::Option* const points = command.add_option(
        "--points", options.points, "Two points of the organ, \"ax ay az bx by bz\", m; with --length");
    CLI::Option* const length =
        command.add_option("--length", options.length, "True length between the two points, m")
            ->check(positiveNumber());
    points->needs(length)->excludes(factor);
    length->needs(points);
    addChoice(command, "--keep", options.kept,
              {{"mass", KeptByScaling::Mass}, {"density", KeptByScaling::Density}},
              "What stays: mass (with N/m and N·s/m, the default) or density (mass grows with the volume)");
    command.add_option("-o,--output", options.output, "Project to write; may be the one that is read")
        ->required()
        ->check(writtenAs(".esm"));
}

double wantedFactor(const ScaleOptions& options) {
    if (options.factor) return *options.factor;
    if (!options.length) throw UsageError("give --factor, or --points and --length");
    const std::vector<double> p = parseNumbers(options.points, "--points");
    if (p.size() != 6) throw UsageError("--points: give 6 numbers, \"ax ay az bx by bz\"");
    const Eigen::Vector3d from(p[0], p[1], p[2]), to(p[3], p[4], p[5]);
    if (from == to) throw UsageError("--points: the two points are one; choose two apart");
    return scaleFactor(from, to, *options.length);
}

/// Inferred masses are the fuzzy system's word, whatever the size.
bool infersMass(const Project& project) {
    return std::any_of(project.regions.begin(), project.regions.end(), [](const Region& region) {
        return !region.held.mass && region.system && outputFor(*region.system, Parameter::Mass);
    });
}

Report runScale(const ScaleOptions& options, Context& context) {
    const double factor = wantedFactor(options);
    context.subject = options.project;
    const ProjectOutput output(options.output);
    const Project opened = openedProject(options.project, context);
    const Project project = scaled(opened, factor, options.kept);
    output.save(project);
    Report report = modelReport(project);
    report.json["factor"] = factor;
    std::vector<std::string> warnings;
    if (project.stepping && isFromOtherTissue(*project.stepping, evaluateModel(project)))
        warnings.emplace_back(
            "the recommended step was measured on the organ as large as it was: measure again "
            "with tradeoff");
    if (options.kept == KeptByScaling::Density && infersMass(project))
        warnings.emplace_back(
            "masses that fuzzy systems infer stay as they are: hold them by hand to scale them");
    const auto isCut = [&](const TextureLayer& layer) {
        return layer.finish && layer.finish->relief * factor > deepestRelief;
    };
    if (std::any_of(opened.layers.begin(), opened.layers.end(), isCut))
        warnings.push_back("reliefs are cut to " + inText(1000 * deepestRelief) +
                           " mm, the most there may be");
    addWarnings(report, warnings);
    addWritten(report, options.output);
    return report;
}

} // namespace

void addScaleCommand(CLI::App& app, Context& context) {
    addCommand(app, context,
               Command<ScaleOptions>{"scale", "Make an organ larger or smaller, with all that lies on it",
                                     declareScale, runScale});
}

} // namespace esm
