#include "app/esmc/arguments.h"
#include "app/esmc/commands.h"
#include "app/esmc/filling_options.h"
#include "app/esmc/filling_report.h"
#include "app/esmc/model_report.h"
#include "app/esmc/opened_file.h"
#include "app/esmc/project_output.h"
#include "core/project/detail_change.h"
#include "core/solid/filled_body.h"

#include <algorithm>
#include <cmath>

namespace esm {

namespace {

struct InsideOptions {
    std::string project, output;
    FillingOptions filling;
};

void declareInside(CLI::App& command, InsideOptions& options) {
    command.add_option("project", options.project, "Project to read (.esm)")->required();
    declareFilling(command, options.filling, "none makes it hollow, every vertex a node");
    command.get_option("--fill")->required();
    command
        .add_option("-o,--output", options.output,
                    "Project to write; may be the one that is read (without: say only what the filling comes "
                    "to)")
        ->check(writtenAs(".esm"));
}

/// Of an absurd spacing no more than can be counted.
std::size_t whole(double count) {
    return static_cast<std::size_t>(std::round(std::min(count, 1e18)));
}

/// What a filling would come to; nothing is filled.
Report estimateReport(const Project& project, const LatticeFilling& filling, const Progress& progress) {
    const LatticeEstimate estimate = estimateLattice(*project.mesh, filling, progress);
    Report report;
    addFilling(report.json, filling);
    report.json["nodes"] = std::round(estimate.nodes);
    report.json["springs"] = std::round(estimate.springs);
    report.json["tetrahedra"] = std::round(estimate.tetrahedra);
    report.json["bytes"] = std::round(estimate.bytes);
    report.text.push_back(
        fillingText(filling) + (isWall(filling) ? ": " : ": about ") +
        counted(whole(estimate.nodes), "node") + ", " + counted(whole(estimate.springs), "spring") + ", " +
        counted(whole(estimate.tetrahedra), "tetrahedron", "tetrahedra") + "; filling takes about " +
        std::to_string(whole(estimate.bytes / 1e6)) + " MB of memory");
    if (!isWall(filling)) addCrossings(report, estimate.crossings);
    std::vector<std::string> warnings;
    if (!isWall(filling) && estimate.spacing < 0.99 * filling.spacing)
        warnings.push_back("the organ is too thin for that spacing: neighbours would lie about " +
                           inText(estimate.spacing) + " m apart");
    if (estimate.nodes > mostLatticeNodes)
        warnings.push_back("more than " + std::to_string(whole(mostLatticeNodes)) +
                           " nodes are refused: choose " +
                           (isWall(filling) ? "fewer layers" : "a wider spacing"));
    addWarnings(report, warnings);
    return report;
}

Report runInside(const InsideOptions& options, Context& context) {
    context.subject = options.project;
    std::optional<ProjectOutput> output;
    if (!options.output.empty()) output.emplace(options.output);
    const Project opened = openedProject(options.project, context);
    const auto filling = chosenFilling(*opened.mesh, options.filling, opened.base.wallThickness);
    if (!output && !filling) throw UsageError("--fill none: say with -o where the hollow organ goes");
    if (!output) return estimateReport(opened, *filling, progressOf(context, "looking for crossings"));
    const Detail detail = filling ? Detail{Detail::Kind::Filled, 0, filling} : hollowDetail(opened);
    const Project filled = withDetail(opened, detail, progressOf(context, "filling"));
    const NarrowCrossings crossings =
        filling ? narrowCrossings(*opened.mesh, *filling, progressOf(context, "looking for crossings"))
                : NarrowCrossings{};
    Report report = saveAndReport(filled, *output);
    if (filling && !isWall(*filling)) addCrossings(report, crossings);
    return report;
}

} // namespace

void addInsideCommand(CLI::App& app, Context& context) {
    addCommand(
        app, context,
        Command<InsideOptions>{"inside",
                               "Fill a closed organ with a lattice of springs, give it a wall of prisms, or "
                               "hollow it",
                               declareInside, runInside});
}

} // namespace esm
