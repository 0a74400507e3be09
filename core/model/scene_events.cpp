#include "core/model/scene_events.h"

#include <algorithm>

namespace esm {

namespace {

bool changes(const PartPressure& pressure) {
    return !isConstant(pressure);
}

} // namespace

bool hasEvents(const Scene& scene) {
    return !scene.forces.empty() || !scene.moves.empty() || !scene.instruments.empty() ||
           !scene.splits.empty() || std::any_of(scene.pressures.begin(), scene.pressures.end(), changes);
}

Scene withoutEvents(Scene scene) {
    if (!hasEvents(scene)) return scene;
    scene.forces.clear();
    scene.moves.clear();
    scene.instruments.clear();
    scene.splits.clear();
    std::erase_if(scene.pressures, changes);
    scene.duration = Scene{}.duration;
    scene.record = {}; // which may name nodes that splits would make
    return scene;
}

} // namespace esm
