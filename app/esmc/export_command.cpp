#include "app/esmc/arguments.h"
#include "app/esmc/authorship_options.h"
#include "app/esmc/commands.h"
#include "app/esmc/opened_file.h"
#include "app/esmc/picture_options.h"
#include "core/exchange/simulators/exporters.h"
#include "core/model/tissue_digest.h"
#include "core/offscreen/preview_picture.h"

#include <cmath>

namespace esm {

namespace {

struct ExportOptions {
    std::string project, output;
    const Exporter* exporter = nullptr;
    PictureOptions pictures;
    Authorship authorship;
    EngineSettings engine;
    CLI::App* command = nullptr; ///< that was told which options were given
    bool isDryRun = false;
};

constexpr double leastExportedStep = 1e-12, mostExportedStep = 1; // s
constexpr const char *timeStepOption = "--dt", *dampingOption = "--damping", *sofaOption = "--sofa";

void declareEngine(CLI::App& command, EngineSettings& engine) {
    command.add_option(timeStepOption, engine.timeStep, "Time step of an engine's scene, s")
        ->check(numberWithin(leastExportedStep, mostExportedStep))
        ->option_text("SECONDS");
    addDampingOption(command, engine.damping);
    addChoice(command, sofaOption, engine.sofaVersion, "Release of SOFA to write for; the newest without");
}

void declareExport(CLI::App& command, ExportOptions& options) {
    options.command = &command;
    command.add_option("project", options.project, "Project to read (.esm)")->required();
    Words<const Exporter*> words;
    std::vector<std::string> purposes, endings;
    for (const Exporter& exporter : exporters()) {
        words.emplace_back(exporter.name, &exporter);
        if (!exporter.otherName.empty()) words.emplace_back(exporter.otherName, &exporter);
        purposes.push_back(exporter.name + ": " + exporter.purpose);
        endings.push_back(exporter.ending);
    }
    // Before the output, whose ending is that of a format there is.
    addChoice(command, "--to", options.exporter, words, joined(purposes, "; "))->required();
    command.add_option("-o,--output", options.output, "File or folder to write (" + joined(endings) + ")")
        ->required();
    declarePictures(command, options.pictures);
    declareAuthorship(command, options.authorship);
    declareEngine(command, options.engine);
    command.add_flag("--dry-run", options.isDryRun, "Say what will differ, and write nothing");
}

bool isGiven(const ExportOptions& options, const char* name) {
    return options.command->count(name) > 0;
}

/// @throws UsageError for what says how an engine steps where none does
void checkEngine(const ExportOptions& options) {
    const Exporter& exporter = *options.exporter;
    for (const char* name : {timeStepOption, dampingOption})
        if (isGiven(options, name) && !exporter.isStepped)
            throw UsageError(std::string(name) + ": a " + exporter.ending +
                             " does not say how the organ is stepped");
    if (isGiven(options, sofaOption) && !exporter.hasReleases)
        throw UsageError(std::string(sofaOption) + ": goes with --to sofa");
}

/// @throws UsageError
void checkUse(const ExportOptions& options) {
    const Exporter& exporter = *options.exporter;
    if (const std::string problem = endingProblem(options.output, exporter.ending); !problem.empty())
        throw UsageError("--output: " + problem);
    if (options.pictures.isFormatGiven && !exporter.holdsPictures)
        throw UsageError("--pictures: a " + exporter.ending + " holds no PNG or JPEG");
    if (const std::string given = givenAuthorship(options.authorship);
        !given.empty() && !exporter.holdsAuthorship)
        throw UsageError(given + ": a " + exporter.ending + " does not say where it comes from");
    checkPictures(options.pictures);
    checkAuthorship(options.authorship);
    checkEngine(options);
}

void addFiles(Report& report, const std::filesystem::path& output) {
    std::uintmax_t bytes = 0;
    for (const std::filesystem::path& file : exportedFiles(output)) {
        report.json["files"].push_back(file.string());
        bytes += std::filesystem::file_size(file);
    }
    report.json["bytes"] = bytes;
    addWritten(report, output);
}

void addDifferences(Report& report, const Differences& differences) {
    report.json["differences"] = Json::array();
    for (const auto& [what, instead] : differences.list) {
        report.json["differences"].push_back({{"what", what}, {"instead", instead}});
        report.text.push_back("will differ: " + what + "; " + instead);
    }
    if (!differences.refusal.empty()) {
        report.json["refusal"] = differences.refusal;
        report.text.push_back("cannot be handed over: " + differences.refusal);
    }
    if (differences.scheme.empty()) return;
    const auto largest =
        std::isfinite(differences.largestStep) ? std::optional(differences.largestStep) : std::nullopt;
    report.json["scheme"] = differences.scheme;
    report.json["dt"] = differences.timeStep;
    report.json["largest_step"] = inJson(largest);
    report.text.push_back("stepped by " + differences.scheme + ", in steps of " +
                          inText(differences.timeStep) +
                          " s; largest stable step: " + (largest ? inText(*largest) + " s" : "no limit"));
}

std::vector<std::string> warningsOf(const Handover& handover, const Differences& differences) {
    std::vector<std::string> warnings;
    const auto& stepping = handover.project.stepping;
    if (stepping && isFromOtherTissue(*stepping, handover.tissue))
        warnings.push_back("the tissue has changed since its step was recommended: measure again with "
                           "tradeoff, and export again");
    if (differences.blowsUp())
        warnings.push_back("the motion will blow up: steps of " + inText(differences.timeStep) +
                           " s are longer than the largest stable one; give a shorter --dt, or none");
    else if (!differences.caution.empty())
        warnings.push_back("the motion may be far from that here: " + differences.caution +
                           "; give a shorter --dt, or none");
    return warnings;
}

Report runExport(const ExportOptions& options, Context& context) {
    checkUse(options);
    context.subject = options.project;
    requireFree(options.output, *options.exporter);
    const Project project = openedProject(options.project, context);
    ProgressParts parts(progressOf(context, "exporting"));
    const Handover handover = handoverFor(options.output, project, parts.next(0.2));
    HandoverMeans means{parts.next(0.1), previewPicture, options.pictures.encoding, options.engine,
                        options.authorship};
    const Differences differences = differencesOf(handover, *options.exporter, means);
    Report report;
    if (const auto warnings = warningsOf(handover, differences); !warnings.empty())
        addWarnings(report, warnings);
    if (!options.isDryRun) {
        means.progress = parts.rest();
        if (!differences.scheme.empty()) means.engine.timeStep = differences.timeStep;
        exportHandover(handover, *options.exporter, options.output, means);
        addFiles(report, options.output);
    }
    addDifferences(report, differences);
    return report;
}

} // namespace

void addExportCommand(CLI::App& app, Context& context) {
    addCommand(
        app, context,
        Command<ExportOptions>{"export", "Hand a project over to a simulator", declareExport, runExport});
}

} // namespace esm
