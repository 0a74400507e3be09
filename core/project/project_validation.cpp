#include "core/project/project.h"
#include "core/support/errors.h"
#include "core/support/numbers.h"
#include "core/support/offenders.h"
#include "core/texture/texture_limits.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace esm {

namespace {

using Problems = std::vector<std::string>;

void requireValue(Problems& problems, const std::string& name, double value, bool zeroAllowed) {
    if (zeroAllowed ? isAmount(value) : isMass(value)) return;
    problems.push_back(name + (zeroAllowed ? " must be 0 or more" : " must be above 0") + " and at most " +
                       numberText(largestNumber));
}

Problems regionProblems(const Region& region) {
    Problems problems;
    if (region.ellipsoid) addUnder(problems, "ellipsoid", validate(*region.ellipsoid));
    requireValue(problems, "the soft rim", region.rim, true);
    if (region.held.springConstant)
        requireValue(problems, "the spring constant", *region.held.springConstant, true);
    if (region.held.viscosity) requireValue(problems, "the viscosity", *region.held.viscosity, true);
    if (region.held.mass) requireValue(problems, "the mass", *region.held.mass, false);
    if (!region.system) return problems;
    addUnder(problems, "fuzzy system " + region.system->name, validate(*region.system));
    try {
        orderedInputs(*region.system, region.inputs);
    } catch (const InvalidModel& error) {
        problems.insert(problems.end(), error.problems().begin(), error.problems().end());
    }
    return problems;
}

void requireLength(Problems& problems, const std::string& name, double length) {
    if (length >= texture_limits::shortestPhoto && length <= texture_limits::longestPhoto) return;
    problems.push_back(name + " must be from 1 micrometre to 1 kilometre");
}

void requireView(Problems& problems, const Projector& projector) {
    using namespace texture_limits;
    if (!projector.intrinsics) {
        if (projector.fieldOfView >= narrowestView && projector.fieldOfView <= widestView) return;
        problems.emplace_back("the projector's field of view must be from 0.1 to 170 degrees");
        return;
    }
    const auto [fx, fy, cx, cy] = *projector.intrinsics;
    if (!(std::min(fx, fy) > 0 && std::max(fx, fy) <= longestFocalLength))
        problems.emplace_back("the projector's focal lengths must be above 0 and at most 1e7 pixels");
    if (!(std::abs(cx) <= longestFocalLength && std::abs(cy) <= longestFocalLength))
        problems.emplace_back("the projector's principal point must be at most 1e7 pixels away");
}

Problems photoProblems(const TextureLayer& layer) {
    Problems problems = paintingProblems(layer);
    if (!layer.photo && !layer.preparation.isNothing())
        problems.emplace_back("prepares a photo, but has none");
    if (!layer.projector.pose.matrix().allFinite())
        problems.emplace_back("the projector's place is not finite");
    if (layer.projector.kind == ProjectorKind::Perspective) {
        requireView(problems, layer.projector);
    } else {
        requireLength(problems, "the projector's width", layer.projector.width);
        requireLength(problems, "the projector's height", layer.projector.height);
    }
    requireValue(problems, "the blending width", layer.blendPixels, true);
    if (!(layer.opacity >= 0 && layer.opacity <= 1)) problems.emplace_back("the opacity must be from 0 to 1");
    if (layer.landmarks.size() > texture_limits::mostLandmarks)
        problems.push_back("has more than " + std::to_string(texture_limits::mostLandmarks) + " landmarks");
    if (layer.photo) {
        const Problems found =
            validate(layer.preparation, layer.photo->image.width, layer.photo->image.height);
        problems.insert(problems.end(), found.begin(), found.end());
    }
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
    if (project.atlas) {
        const Problems found = validate(*project.atlas, project.mesh->triangles.size());
        problems.insert(problems.end(), found.begin(), found.end());
    }
    if (photoPixels(project) > texture_limits::mostPixelsOfAllPhotos)
        problems.push_back("the photos have more than " +
                           std::to_string(texture_limits::mostPixelsOfAllPhotos / 1'000'000) +
                           " megapixels together; use fewer or smaller photos");
    return problems;
}

Problems networkProblems(const Project& project) {
    Problems problems = carryingProblems(*project.mesh, *project.network);
    requireValue(problems, "the organ's spring constant", project.base.springConstant, true);
    requireValue(problems, "the organ's viscosity", project.base.viscosity, true);
    requireValue(problems, "the organ's mass", project.base.mass, false);
    if (project.base.stiffening) {
        const Problems found = validate(*project.base.stiffening);
        problems.insert(problems.end(), found.begin(), found.end());
    }
    return problems;
}

} // namespace

std::vector<std::string> validate(const Project& project) {
    if (!project.mesh || !project.network || !project.importReport)
        return {"the project has no organ; import a mesh"};
    Problems problems;
    addUnder(problems, "mesh", validate(*project.mesh));
    addUnder(problems, "model", networkProblems(project));
    addUnder(problems, "scene", validate(project.scene, project.network->restPositions.size()));
    if (project.stepping) addUnder(problems, "stepping", validate(*project.stepping));
    for (std::size_t i = 0; i < project.regions.size(); ++i)
        addUnder(problems, "region " + std::to_string(i + 1) + " (" + project.regions[i].name + ")",
                 regionProblems(project.regions[i]));
    for (std::size_t i = 0; i < project.layers.size(); ++i)
        addUnder(problems, "photo " + std::to_string(i + 1) + " (" + project.layers[i].name + ")",
                 photoProblems(project.layers[i]));
    addUnder(problems, "texture", textureProblems(project));
    // Only sound parts can be evaluated together.
    if (problems.empty()) addUnder(problems, "model", validate(evaluateModel(project)));
    return problems;
}

} // namespace esm
