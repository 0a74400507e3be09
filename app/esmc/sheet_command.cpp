#include "app/esmc/arguments.h"
#include "app/esmc/commands.h"
#include "app/esmc/model_report.h"
#include "app/esmc/opened_file.h"
#include "app/esmc/project_output.h"
#include "core/authoring/even_sheet.h"
#include "core/support/errors.h"

namespace esm {

namespace {

struct SheetOptions {
    std::string project, output;
    bool isEven = true;
};

void declareSheet(CLI::App& command, SheetOptions& options) {
    command.add_option("project", options.project, "Project to read (.esm)")->required();
    addSpringsChoice(command, options.isEven)->required();
    command.add_option("-o,--output", options.output, "Project to write; may be the one that is read")
        ->required()
        ->check(writtenAs(".esm"));
}

Report runSheet(const SheetOptions& options, Context& context) {
    context.subject = options.project;
    const ProjectOutput output(options.output);
    const Project opened = openedProject(options.project, context);
    if (!canBeEvenSheet(opened))
        throw InvalidModel("is no surface of springs: what is filled or rigid, and lines, are no sheet");
    return saveAndReport(withEvenSheet(opened, options.isEven, progressOf(context, "sharing out")), output);
}

} // namespace

void addSheetCommand(CLI::App& app, Context& context) {
    addCommand(app, context,
               Command<SheetOptions>{"sheet", "Say whether a surface's springs make an even sheet",
                                     declareSheet, runSheet});
}

} // namespace esm
