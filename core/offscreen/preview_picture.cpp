#include "core/offscreen/preview_picture.h"

#include "core/offscreen/offscreen.h"
#include "core/render/drawn_shape.h"
#include "core/texture/layers/page_levels.h"

namespace esm {

Image previewPicture(const Project& project, const std::shared_ptr<const std::vector<Image>>& pages) {
    constexpr int size = 512; // pixels
    RenderScene scene;
    scene.mesh = project.mesh;
    scene.network = project.network;
    scene.baseColour = project.texture.baseColour;
    // A pure motion model has nothing but springs to show.
    scene.showSprings = project.mesh->triangles.empty();
    if (pages) {
        scene.atlas = project.atlas;
        scene.texturePages = pages;
        scene.smallerPages = std::make_shared<const SmallerPages>(smallerPages(*project.atlas, *pages));
    }
    const Camera camera = framedCamera(organBox(*project.mesh, *project.network), StandardView::Front, 1);
    return renderOffscreen(scene, camera, size, size);
}

} // namespace esm
