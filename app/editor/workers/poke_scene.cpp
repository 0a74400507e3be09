#include "app/editor/workers/poke_scene.h"

namespace esm {

RenderScene sceneAt(const RenderScene& shown, const PokeMotion& motion, double time) {
    const PokePicture& picture = pictureAt(motion, time);
    RenderScene scene = shown;
    if (scene.network != motion.project.network) {
        scene.nodePaint.reset();
        scene.springPaint.reset();
        scene.marked.reset();
        scene.fixedNodes.clear();
    }
    scene.network = motion.project.network;
    scene.nodePositions = inDoubles(picture.positions);
    scene.instruments.clear();
    scene.heldInstrument = picture.instrument;
    return scene;
}

} // namespace esm
