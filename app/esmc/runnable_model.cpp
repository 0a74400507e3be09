#include "app/esmc/runnable_model.h"

#include "app/esmc/opened_file.h"
#include "core/exchange/scene_file.h"
#include "core/support/errors.h"

namespace esm {

namespace {

/// @throws InvalidModel
void requireValid(const Scene& scene, const SpringNetwork& network) {
    if (auto problems = validate(scene, network.restPositions.size()); !problems.empty())
        throw InvalidModel(std::move(problems));
}

RunnableModel fromProject(const std::filesystem::path& file, const std::optional<Scene>& scene,
                          Context& context) {
    const Project project = openedProject(file, context);
    RunnableModel model;
    model.surface = touchedSurface(*project.mesh, *project.network);
    model.scene = scene.value_or(project.scene);
    model.stepping = project.stepping;
    requireValid(model.scene, *project.network);
    model.tissue = evaluateModel(project, model.scene);
    model.project = project;
    return model;
}

/// A package holds tethers and fixed nodes as numbers; those of a scene take their place.
RunnableModel fromPackage(const std::filesystem::path& file, const std::optional<Scene>& scene,
                          Context& context) {
    ModelPackage package = openedPackage(file, context);
    RunnableModel model;
    model.tissue = std::move(package.tissue);
    model.scene = scene.value_or(Scene());
    model.stepping = package.stepping;
    model.surface = touchedSurface(package.mesh, *model.tissue.network);
    if (!scene) return model;
    requireValid(*scene, *model.tissue.network);
    Project bare;
    bare.network = model.tissue.network;
    const TissueModel held = evaluateModel(bare, *scene);
    model.tissue.tethers = held.tethers;
    model.tissue.fixedNodes = held.fixedNodes;
    return model;
}

} // namespace

RunnableModel loadRunnableModel(const std::filesystem::path& file, const std::filesystem::path& sceneFile,
                                Context& context) {
    context.subject = sceneFile.empty() ? file : sceneFile;
    const bool isPackage = isModelPackage(file);
    std::optional<Scene> scene;
    if (!sceneFile.empty()) scene = readSceneFile(sceneFile);
    RunnableModel model = isPackage ? fromPackage(file, scene, context) : fromProject(file, scene, context);
    context.subject = file;
    return model;
}

} // namespace esm
