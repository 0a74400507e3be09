#include "core/project/project.h"
#include "core/support/errors.h"
#include "core/support/offenders.h"
#include "core/texture/texture_limits.h"

#include <set>

namespace esm {

namespace {

using Problems = std::vector<std::string>;

void add(Problems& problems, const Problems& found) {
    problems.insert(problems.end(), found.begin(), found.end());
}

Problems regionProblems(const Region& region) {
    Problems problems;
    if (region.ellipsoid) addUnder(problems, "ellipsoid", validate(*region.ellipsoid));
    add(problems, fieldProblems(region));
    add(problems, fieldProblems(region.held));
    if (!region.system) return problems;
    addUnder(problems, "fuzzy system " + region.system->name, validate(*region.system));
    try {
        orderedInputs(*region.system, region.inputs);
    } catch (const InvalidModel& error) {
        add(problems, error.problems());
    }
    return problems;
}

Problems photoProblems(const TextureLayer& layer) {
    Problems problems = paintingProblems(layer);
    if (!layer.photo && !layer.preparation.isNothing())
        problems.emplace_back("prepares a photo, but has none");
    if (!layer.projector.pose.matrix().allFinite())
        problems.emplace_back("the projector's place is not finite");
    add(problems, fieldProblems(layer.projector));
    if (layer.projector.hasIntrinsics()) add(problems, fieldProblems(*layer.projector.intrinsics));
    add(problems, fieldProblems(layer));
    if (layer.finish) add(problems, validate(*layer.finish));
    if (layer.landmarks.size() > texture_limits::mostLandmarks)
        problems.push_back("has more than " + std::to_string(texture_limits::mostLandmarks) + " landmarks");
    if (layer.photo)
        add(problems, validate(layer.preparation, layer.photo->image.width, layer.photo->image.height));
    return problems;
}

/// Pixels of all photos, each counted once however often it is laid, and of what each layer prepares, which
/// opening the project's file makes for each layer anew.
std::uint64_t photoPixels(const Project& project) {
    std::set<const Image*> counted;
    std::uint64_t pixels = 0;
    for (const TextureLayer& layer : project.layers) {
        if (layer.photo && counted.insert(&layer.photo->image).second)
            pixels += layer.photo->image.pixels.size() / 4;
        if (layer.prepared) pixels += layer.prepared->pixels.size() / 4;
    }
    return pixels;
}

Problems textureProblems(const Project& project) {
    Problems problems = validate(project.texture.atlas);
    add(problems, fieldProblems(project.texture));
    if (project.texture.finish) add(problems, fieldProblems(*project.texture.finish));
    if (project.atlas) add(problems, validate(*project.atlas, project.mesh->triangles.size()));
    if (photoPixels(project) > texture_limits::mostPixelsOfAllPhotos)
        problems.push_back("the photos have more than " +
                           std::to_string(texture_limits::mostPixelsOfAllPhotos / 1'000'000) +
                           " megapixels together; use fewer or smaller photos");
    return problems;
}

Problems networkProblems(const Project& project) {
    Problems problems = carryingProblems(*project.mesh, *project.network);
    add(problems, fieldProblems(project.base));
    if (project.base.stiffening) add(problems, fieldProblems(*project.base.stiffening));
    return problems;
}

Problems partProblems(const Project& project) {
    if (!project.mesh || !project.network || !project.importReport)
        return {"the project has no organ; import a mesh"};
    Problems problems;
    addUnder(problems, "mesh", validate(*project.mesh));
    if (project.source) addUnder(problems, "source", validate(*project.source));
    addUnder(problems, "model", networkProblems(project));
    addUnder(problems, "scene", validate(project.scene, project.network->restPositions.size()));
    if (project.stepping) addUnder(problems, "stepping", validate(*project.stepping));
    if (project.accuracy) addUnder(problems, "speed and accuracy", validate(*project.accuracy));
    for (std::size_t i = 0; i < project.regions.size(); ++i)
        addUnder(problems, "region " + std::to_string(i + 1) + " (" + project.regions[i].name + ")",
                 regionProblems(project.regions[i]));
    for (const auto& system : project.spareSystems)
        addUnder(problems, "fuzzy system " + system->name, validate(*system));
    for (std::size_t i = 0; i < project.layers.size(); ++i)
        addUnder(problems, "photo " + std::to_string(i + 1) + " (" + project.layers[i].name + ")",
                 photoProblems(project.layers[i]));
    addUnder(problems, "texture", textureProblems(project));
    return problems;
}

} // namespace

// Only sound parts can be evaluated together.
TissueModel soundModel(const Project& project) {
    Problems problems = partProblems(project);
    if (!problems.empty()) throw InvalidModel(std::move(problems));
    TissueModel model = evaluateModel(project);
    addUnder(problems, "model", validate(model));
    if (!problems.empty()) throw InvalidModel(std::move(problems));
    return model;
}

std::vector<std::string> validate(const Project& project) {
    try {
        soundModel(project);
        return {};
    } catch (const InvalidModel& error) {
        return error.problems();
    }
}

} // namespace esm
