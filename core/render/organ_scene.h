#pragma once

#include "core/project/region.h"
#include "core/render/renderer.h"
#include "core/texture/layers/texture_layer.h"

/// What every picture of an organ shows alike, in the window and in files.
namespace esm {

/// The organ at rest, bare. A pure motion model has nothing but springs to show, and shows them.
RenderScene organScene(std::shared_ptr<const TriangleMesh> mesh, std::shared_ptr<const SpringNetwork> network,
                       const Colour& baseColour);

/// Lays a texture on it. @param atlas not null
void layTexture(RenderScene& scene, std::shared_ptr<const Atlas> atlas, const std::vector<Image>& pages);

/// How it shines, see `finishPages`; as it always did where nothing has a finish. @param base of the surface
/// where layers have none
void layFinish(RenderScene& scene, const std::vector<TextureLayer>& layers,
               const std::optional<SurfaceFinish>& base, std::shared_ptr<const TiledPages> pages);

/// Precondition: the region has an ellipsoid.
DrawnEllipsoid drawnEllipsoid(const Region& region, bool isSelected);

/// The projector of a photo, before the organ and its texture as the scene has them. Where the photo is
/// hidden, so is the picture on the box's face.
DrawnProjector drawnProjector(const RenderScene& scene, const TextureLayer& layer, bool isSelected);

/// How much of its picture a projector's face may show, 0 to 1, lest it hide from the viewer what the photo
/// looks like on the organ: all from the side, nothing where one looks along the projector's axis.
double faceShare(const DrawnProjector& drawn, const Camera& camera);

} // namespace esm
