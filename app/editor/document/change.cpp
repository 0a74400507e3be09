#include "app/editor/document/change.h"

#include <algorithm>

namespace esm {

namespace {

template<class Same>
bool sameLayers(const std::vector<TextureLayer>& a, const std::vector<TextureLayer>& b, const Same& same) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), same);
}

bool sameTissue(const Region& a, const Region& b) {
    Region alike = b;
    alike.name = a.name;
    alike.colour = a.colour;
    return a == alike;
}

bool sameLandmarks(const TextureLayer& a, const TextureLayer& b) {
    return a.landmarks == b.landmarks;
}

} // namespace

bool sameReach(const Region& a, const Region& b) {
    return a.ellipsoid == b.ellipsoid && a.rim == b.rim;
}

bool sameButForLandmarks(const TextureLayer& a, const TextureLayer& b) {
    if (a.landmarks == b.landmarks) return a == b;
    TextureLayer other = b;
    other.landmarks = a.landmarks;
    return a == other;
}

Change difference(const Project& before, const Project& after) {
    Change change;
    change.name = before.name != after.name;
    change.mesh = before.mesh != after.mesh || before.network != after.network ||
                  before.importReport != after.importReport || before.source != after.source;
    change.tissue = before.base != after.base;
    change.regions = before.regions != after.regions;
    change.regionTissue = !std::equal(before.regions.begin(), before.regions.end(), after.regions.begin(),
                                      after.regions.end(), sameTissue);
    change.spareSystems = before.spareSystems != after.spareSystems;
    change.scene = before.scene != after.scene;
    change.stepping = before.stepping != after.stepping;
    change.accuracy = before.accuracy != after.accuracy;
    change.layers = !sameLayers(before.layers, after.layers, sameButForLandmarks);
    change.landmarks = !sameLayers(before.layers, after.layers, sameLandmarks);
    change.texture = before.texture != after.texture || before.atlas != after.atlas;
    return change;
}

} // namespace esm
