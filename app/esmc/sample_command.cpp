#include "app/esmc/arguments.h"
#include "app/esmc/commands.h"
#include "app/esmc/model_report.h"
#include "core/samples/samples.h"

#include <algorithm>

namespace esm {

namespace {

struct SampleOptions {
    std::string name, output;
};

std::vector<std::string> organsAndPhotos() {
    std::vector<std::string> names = sampleNames();
    names.insert(names.end(), samplePhotoNames().begin(), samplePhotoNames().end());
    return names;
}

void declareSample(CLI::App& command, SampleOptions& options) {
    command
        .add_option("name", options.name,
                    "An organ: " + joined(sampleNames()) + "; or a photograph: " + joined(samplePhotoNames()))
        ->required()
        ->check(oneOf(organsAndPhotos()));
    command.add_option("-o,--output", options.output, "Project (.esm) or picture (.png) to write")
        ->required();
}

Report writePhoto(const SampleOptions& options) {
    const auto photo = makeSamplePhoto(options.name);
    writeFileAtomically(options.output, photo->encoded);
    Report report;
    report.json["files"] = {options.output};
    report.json["size"] = {photo->image.width, photo->image.height};
    addWritten(report, options.output);
    return report;
}

Report writeOrgan(const SampleOptions& options) {
    const ProjectOutput output(options.output);
    return saveAndReport(makeSample(options.name), output);
}

Report runSample(const SampleOptions& options, Context&) {
    const auto& organs = sampleNames();
    const bool isOrgan = std::find(organs.begin(), organs.end(), options.name) != organs.end();
    const std::string problem = endingProblem(options.output, isOrgan ? ".esm" : ".png");
    if (!problem.empty()) throw UsageError("--output: " + problem);
    return isOrgan ? writeOrgan(options) : writePhoto(options);
}

} // namespace

void addSampleCommand(CLI::App& app, Context& context) {
    addCommand(app, context,
               Command<SampleOptions>{"sample", "Make a project of one of the program's own organs",
                                      declareSample, runSample});
}

} // namespace esm
