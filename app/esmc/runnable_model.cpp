#include "app/esmc/runnable_model.h"

#include "app/esmc/opened_file.h"
#include "core/exchange/project/scene_file.h"
#include "core/project/surroundings.h"
#include "core/support/errors.h"

#include <algorithm>

namespace esm {

namespace {

/// @throws InvalidModel
void requireValid(const Scene& scene, const SpringNetwork& network) {
    if (auto problems = validate(scene, network.restPositions.size()); !problems.empty())
        throw InvalidModel(std::move(problems));
}

/// A scene's fixed nodes, tethers and fluids take the place of those that are stored, also where it has none.
struct StoredHolds {
    std::size_t fixed, tethers, fillings;
};

std::vector<std::string> droppedHolds(const Scene& scene, const StoredHolds& stored) {
    const auto& [fixed, tethers, fillings] = stored;
    std::vector<std::string> warnings;
    if (scene.fixed.empty() && fixed > 0)
        warnings.push_back("the scene names no fixed nodes: those stored (" + std::to_string(fixed) +
                           ") do not hold in this run");
    if (scene.tethers.empty() && tethers > 0)
        warnings.push_back("the scene names no tethers: those stored (" + std::to_string(tethers) +
                           ") do not hold in this run");
    if (scene.fillings.empty() && fillings > 0)
        warnings.push_back("the scene names no fillings: those stored (" + std::to_string(fillings) +
                           ") do not resist in this run");
    return warnings;
}

RunnableModel fromProject(const std::filesystem::path& file, const std::optional<Scene>& scene,
                          Context& context) {
    const Project project = openedProject(file, context);
    RunnableModel model;
    model.surface = touchedSurface(*project.mesh, *project.network);
    model.scene = scene.value_or(project.scene);
    model.stepping = project.stepping;
    requireValid(model.scene, *project.network);
    model.mesh = project.mesh;
    if (scene)
        model.warnings = droppedHolds(*scene, {fixedNodesOf(*project.network, project.scene).size(),
                                               tetherCountOf(*project.network, project.scene),
                                               project.scene.fillings.size()});
    model.tissue = evaluateModel(project, model.scene);
    model.project = project;
    return model;
}

/// A package holds tethers, fixed nodes, fluids and pressures by themselves; those of a scene take their
/// place.
RunnableModel fromPackage(const std::filesystem::path& file, const std::optional<Scene>& scene,
                          Context& context) {
    ModelPackage package = openedPackage(file, context);
    RunnableModel model;
    model.tissue = std::move(package.tissue);
    model.scene = scene.value_or(Scene());
    if (!scene) model.scene.pressures = std::move(package.pressures);
    model.stepping = package.stepping;
    model.mesh = std::make_shared<const TriangleMesh>(std::move(package.mesh));
    model.surface = touchedSurface(*model.mesh, *model.tissue.network);
    if (!scene) return model;
    requireValid(*scene, *model.tissue.network);
    Project bare;
    bare.network = model.tissue.network;
    bare.mesh = model.mesh;
    const TissueModel held = evaluateModel(bare, *scene);
    const auto fillings = std::count_if(model.tissue.cavities.begin(), model.tissue.cavities.end(),
                                        [](const Cavity& cavity) { return cavity.stiffness > 0; });
    model.warnings = droppedHolds(*scene, {model.tissue.fixedNodes.size(), model.tissue.tethers.size(),
                                           static_cast<std::size_t>(fillings)});
    model.tissue.tethers = held.tethers;
    model.tissue.fixedNodes = held.fixedNodes;
    model.tissue.cavities = held.cavities;
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

void requireRecording(const Scene& scene) {
    if (scene.record.nodes && scene.record.nodes->empty())
        throw InvalidModel("the scene records no node: name some in \"record\", \"nodes\", or leave the list "
                           "out for all");
}

} // namespace esm
