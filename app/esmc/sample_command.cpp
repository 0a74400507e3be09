#include "app/esmc/arguments.h"
#include "app/esmc/commands.h"
#include "app/esmc/model_report.h"
#include "core/exchange/project_file.h"
#include "core/samples/samples.h"

namespace esm {

namespace {

struct SampleOptions {
    std::string name, output;
};

void declareSample(CLI::App& command, SampleOptions& options) {
    command.add_option("name", options.name, "One of " + joined(sampleNames()))
        ->required()
        ->check(oneOf(sampleNames()));
    command.add_option("-o,--output", options.output, "Project to write (.esm)")->required();
}

Report runSample(const SampleOptions& options, Context&) {
    const Project project = makeSample(options.name);
    saveProject(project, options.output);
    Report report = modelReport(project);
    addWritten(report, options.output);
    return report;
}

} // namespace

void addSampleCommand(CLI::App& app, Context& context) {
    addCommand(app, context, "sample", "Make a project of one of the program's own organs", declareSample, runSample);
}

} // namespace esm
