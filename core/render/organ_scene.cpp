#include "core/render/organ_scene.h"

#include "core/render/drawn_shape.h"

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

void layTexture(RenderScene& scene, std::shared_ptr<const Atlas> atlas, const std::vector<Image>& pages) {
    const auto inTiles = std::make_shared<const TiledPages>(tiled(pages));
    scene.smallerPages = std::make_shared<const SmallerPages>(smallerPages(*atlas, *inTiles));
    scene.atlas = std::move(atlas);
    scene.texturePages = inTiles;
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
