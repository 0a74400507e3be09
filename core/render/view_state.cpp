#include "core/render/view_state.h"

namespace esm {

/// At rest: a plane that followed moving tissue would swim.
void showParts(RenderScene& scene, const ViewState& view, const Camera& camera) {
    scene.showSurface = view.surface;
    scene.showWireframe = view.wireframe;
    scene.showNodes = view.nodes;
    scene.showSprings = view.springs || scene.mesh->triangles.empty();
    scene.light = view.light;
    scene.cut.reset();
    if (view.cut) scene.cut = cutPlane(*view.cut, organBox(*scene.mesh, *scene.network), camera);
}

} // namespace esm
