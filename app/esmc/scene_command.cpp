#include "core/exchange/project/scene_file.h"

#include "app/esmc/arguments.h"
#include "app/esmc/commands.h"
#include "app/esmc/opened_file.h"
#include "app/esmc/project_output.h"
#include "core/exchange/project/project_file.h"
#include "core/support/errors.h"

namespace esm {

namespace {

struct SceneOptions {
    std::string project, scene, output;
};

void declareScene(CLI::App& command, SceneOptions& options) {
    command.add_option("project", options.project, "Project to read (.esm)")->required();
    command.add_option("--scene", options.scene, "Scene to store (.json)")->required();
    command.add_option("-o,--output", options.output, "Project to write; may be the one that is read")
        ->required()
        ->check(writtenAs(".esm"));
}

Report storeScene(const SceneOptions& options, Context& context) {
    context.subject = options.scene;
    const ProjectOutput output(options.output);
    Project project = openedProject(options.project, context);
    project.scene = readSceneFile(options.scene);
    if (auto problems = validate(project.scene, project.network->restPositions.size()); !problems.empty())
        throw InvalidModel(std::move(problems));
    const TissueModel tissue = evaluateModel(project);
    output.save(project);
    Report report;
    report.json["fixed"] = tissue.fixedNodes.size();
    report.json["tethers"] = tissue.tethers.size();
    report.json["duration"] = project.scene.duration;
    report.text.push_back(counted(tissue.fixedNodes.size(), "fixed node") + ", " +
                          counted(tissue.tethers.size(), "tether") + ", " + inText(project.scene.duration) +
                          " s");
    addWarnings(report, sceneWarnings(project.scene, tissue));
    addWritten(report, options.output);
    return report;
}

} // namespace

void addSceneCommand(CLI::App& app, Context& context) {
    addCommand(app, context,
               Command<SceneOptions>{"scene", "Store what holds and moves the organ in a project",
                                     declareScene, storeScene});
}

} // namespace esm
