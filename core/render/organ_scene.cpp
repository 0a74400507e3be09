#include "core/render/organ_scene.h"

#include "core/render/drawn_shape.h"
#include "core/support/smooth_step.h"
#include "core/texture/maps/finish_layers.h"

#include <cmath>

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
    scene.smallerPages = std::make_shared<const SmallerPages>(smallerPages(*scene.mesh, *atlas, *inTiles));
    scene.atlas = std::move(atlas);
    scene.texturePages = inTiles;
}

void layFinish(RenderScene& scene, const std::vector<TextureLayer>& layers,
               const std::optional<SurfaceFinish>& base, std::shared_ptr<const TiledPages> pages) {
    scene.finish.reset();
    if (hasFinish(layers, base)) scene.finish = base.value_or(SurfaceFinish{});
    scene.finishPages = std::move(pages);
}

DrawnEllipsoid drawnEllipsoid(const Region& region, bool isSelected) {
    return {*region.ellipsoid, region.colour, isSelected, region.rim};
}

DrawnProjector drawnProjector(const RenderScene& scene, const TextureLayer& layer, bool isSelected) {
    constexpr double laidCover = 0.24, bareCover = 0.35;
    const bool isShown = layer.visible && layer.opacity > 0;
    DrawnProjector drawn{layer.projector, pictureOf(layer), isSelected};
    drawn.isLaid = scene.texturePages && isShown;
    drawn.cover = !isShown ? 0 : drawn.isLaid ? laidCover : bareCover;
    drawn.depth = shownDepth(layer.projector, boundingBox(scene.mesh->vertices));
    return drawn;
}

/// By the angle between the line of sight and the axis: within 25° the face lies before much of what it is
/// projected on, beyond 60° before little.
double faceShare(const DrawnProjector& drawn, const Camera& camera) {
    constexpr double besideCosine = 0.5, alongCosine = 0.9;
    const Eigen::Isometry3d& pose = drawn.projector.pose;
    const Eigen::Vector3d middle = pose * Eigen::Vector3d(0, 0, -drawn.depth);
    const double along = std::abs(towardsViewer(camera, middle).dot(pose.linear().col(2)));
    return 1 - smoothStep(besideCosine, alongCosine, along);
}

} // namespace esm
