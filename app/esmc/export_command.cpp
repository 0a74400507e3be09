#include "app/esmc/arguments.h"
#include "app/esmc/commands.h"
#include "app/esmc/opened_file.h"
#include "core/exchange/model_package.h"
#include "core/model/tissue_digest.h"
#include "core/offscreen/preview_picture.h"

namespace esm {

namespace {

struct ExportOptions {
    std::string project, output, format;
};

void declareExport(CLI::App& command, ExportOptions& options) {
    command.add_option("project", options.project, "Project to read (.esm)")->required();
    // Before the output, whose ending is that of a format there is.
    command.add_option("--to", options.format, "glb: the model package for simulators")
        ->required()
        ->check(CLI::Validator(
            [](const std::string& format) {
                return format == "glb" ? std::string() : "'" + format + "' is not offered; there is glb";
            },
            ""));
    command.add_option("-o,--output", options.output, "File to write (.glb)")
        ->required()
        ->check(writtenAs(".glb"));
}

Report runExport(const ExportOptions& options, Context& context) {
    context.subject = options.project;
    const Project project = openedProject(options.project, context);
    exportPackage(project, options.output, progressOf(context, "exporting"), previewPicture);
    Report report;
    if (project.stepping && isFromOtherTissue(*project.stepping, evaluateModel(project)))
        addWarnings(report, {"the tissue has changed since its step was recommended: measure again with "
                             "tradeoff, and export again"});
    report.json["files"] = {options.output};
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
