#include "app/esmc/commands.h"
#include "app/esmc/model_report.h"
#include "core/exchange/project/project_file.h"

namespace esm {

namespace {

struct ValidateOptions {
    std::string file;
};

void declareValidate(CLI::App& command, ValidateOptions& options) {
    command.add_option("file", options.file, "Project or model package")->required();
}

Report runValidate(const ValidateOptions& options, Context& context) {
    context.subject = options.file;
    const bool isPackage = isModelPackage(options.file);
    const std::vector<std::string> problems =
        isPackage ? validatePackage(options.file) : validateProjectFile(options.file);
    Report report;
    report.json = {{"valid", problems.empty()}, {"problems", problems}};
    // The error line tells a single problem.
    if (problems.size() > 1) report.text = problems;
    if (problems.empty()) report.text.push_back(options.file + ": all is well");
    if (problems.size() == 1) report.failure = problems.front();
    if (problems.size() > 1)
        report.failure = std::to_string(problems.size()) + " problems; the first: " + problems.front();
    return report;
}

} // namespace

void addValidateCommand(CLI::App& app, Context& context) {
    addCommand(app, context,
               Command<ValidateOptions>{"validate", "Check a project or a model package", declareValidate,
                                        runValidate});
}

} // namespace esm
