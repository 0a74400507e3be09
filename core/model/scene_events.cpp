#include "core/model/scene_events.h"

namespace esm {

Scene withoutEvents(Scene scene) {
    scene.forces.clear();
    scene.moves.clear();
    scene.instruments.clear();
    scene.splits.clear();
    std::erase_if(scene.pressures, [](const PartPressure& pressure) { return !isConstant(pressure); });
    return scene;
}

bool hasEvents(const Scene& scene) {
    return withoutEvents(scene) != scene;
}

} // namespace esm
