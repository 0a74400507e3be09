#include "app/esmc/arguments.h"
#include "app/esmc/commands.h"
#include "app/esmc/opened_file.h"
#include "app/esmc/picture_options.h"
#include "core/exchange/simulators/exporters.h"
#include "core/model/tissue_digest.h"
#include "core/offscreen/preview_picture.h"

namespace esm {

namespace {

struct ExportOptions {
    std::string project, output;
    const Exporter* exporter = nullptr;
    PictureOptions pictures;
};

void declareExport(CLI::App& command, ExportOptions& options) {
    command.add_option("project", options.project, "Project to read (.esm)")->required();
    Words<const Exporter*> words;
    std::vector<std::string> purposes, endings;
    for (const Exporter& exporter : exporters()) {
        words.emplace_back(exporter.name, &exporter);
        purposes.push_back(exporter.name + ": " + exporter.purpose);
        endings.push_back(exporter.ending);
    }
    // Before the output, whose ending is that of a format there is.
    addChoice(command, "--to", options.exporter, words, joined(purposes, "; "))->required();
    command.add_option("-o,--output", options.output, "File to write (" + joined(endings) + ")")->required();
    declarePictures(command, options.pictures);
}

/// @throws UsageError
void checkUse(const ExportOptions& options) {
    const Exporter& exporter = *options.exporter;
    if (const std::string problem = endingProblem(options.output, exporter.ending); !problem.empty())
        throw UsageError("--output: " + problem);
    if (options.pictures.isFormatGiven && !exporter.holdsPictures)
        throw UsageError("--pictures: a " + exporter.ending + " holds no pictures");
    checkPictures(options.pictures);
}

Report runExport(const ExportOptions& options, Context& context) {
    checkUse(options);
    context.subject = options.project;
    const Project project = openedProject(options.project, context);
    exportProject(project, *options.exporter, options.output,
                  {progressOf(context, "exporting"), previewPicture, options.pictures.encoding});
    Report report;
    if (project.stepping && isFromOtherTissue(*project.stepping, evaluateModel(project)))
        addWarnings(report, {"the tissue has changed since its step was recommended: measure again with "
                             "tradeoff, and export again"});
    report.json["files"] = {options.output};
    report.json["bytes"] = std::filesystem::file_size(options.output);
    addWritten(report, options.output);
    return report;
}

} // namespace

void addExportCommand(CLI::App& app, Context& context) {
    addCommand(
        app, context,
        Command<ExportOptions>{"export", "Hand a project over to a simulator", declareExport, runExport});
}

} // namespace esm
