#include "core/offscreen/preview_picture.h"

#include "core/offscreen/offscreen.h"
#include "core/render/colouring.h"
#include "core/render/organ_scene.h"

namespace esm {

Image previewPicture(const Project& project, const BakedPages& pages) {
    constexpr int size = 512; // pixels
    RenderScene scene = organScene(project.mesh, project.network, project.texture.baseColour);
    std::optional<ValueRange> range;
    if (scene.showSprings)
        colourScene(scene, ColourBy::SpringConstant, {evaluateModel(project), project.regions, {}}, range);
    if (pages.colours) layTexture(scene, project.atlas, *pages.colours);
    layFinish(scene, project.layers, project.texture.finish, pages.finish);
    const Camera camera = framedCamera(organBox(*project.mesh, *project.network), StandardView::Front, 1);
    return renderOffscreen(scene, camera, size, size);
}

} // namespace esm
