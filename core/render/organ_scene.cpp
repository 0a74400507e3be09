#include "core/render/organ_scene.h"

#include "core/render/drawn_shape.h"

#include <algorithm>

namespace esm {

RenderScene organScene(std::shared_ptr<const TriangleMesh> mesh, std::shared_ptr<const SpringNetwork> network,
                       const Colour& baseColour) {
    RenderScene scene;
    scene.showSprings = mesh->triangles.empty();
    scene.mesh = std::move(mesh);
    scene.network = std::move(network);
    scene.baseColour = baseColour;
    return scene;
}

void layTexture(RenderScene& scene, std::shared_ptr<const Atlas> atlas,
                std::shared_ptr<const std::vector<Image>> pages) {
    scene.smallerPages = std::make_shared<const SmallerPages>(smallerPages(*atlas, *pages));
    scene.atlas = std::move(atlas);
    scene.texturePages = std::move(pages);
}

std::shared_ptr<const std::vector<double>> springConstants(const TissueModel& tissue) {
    std::vector<double> constants;
    for (const SpringValues& spring : springValues(tissue))
        constants.push_back(spring.springConstant);
    return std::make_shared<const std::vector<double>>(std::move(constants));
}

std::optional<std::pair<double, double>> colourSprings(RenderScene& scene,
                                                       std::shared_ptr<const std::vector<double>> constants) {
    scene.springValues.reset();
    if (constants->empty()) return std::nullopt;
    const auto found = std::minmax_element(constants->begin(), constants->end());
    const double least = *found.first, largest = *found.second;
    scene.springValueMinimum = least;
    scene.springValueMaximum = largest > least ? largest : least + std::max(1e-9, least);
    scene.springValues = std::move(constants);
    return std::pair(least, largest);
}

DrawnEllipsoid drawnEllipsoid(const Region& region, bool isSelected) {
    return {*region.ellipsoid, region.colour, isSelected, region.rim};
}

DrawnProjector drawnProjector(const RenderScene& scene, const TextureLayer& layer, bool isSelected) {
    const bool isLaid = scene.texturePages && layer.visible && layer.opacity > 0;
    return {layer.projector, pictureOf(layer), isSelected, isLaid,
            shownDepth(layer.projector, boundingBox(scene.mesh->vertices))};
}

} // namespace esm
