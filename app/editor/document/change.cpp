#include "app/editor/document/change.h"

#include <algorithm>

namespace esm {

namespace {

template<typename T, typename Same>
bool sameList(const std::vector<T>& a, const std::vector<T>& b, Same same) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), same);
}

bool same(const Ellipsoid& a, const Ellipsoid& b) {
    return a.centre == b.centre && a.radii == b.radii && a.orientation.coeffs() == b.orientation.coeffs();
}

bool same(const std::optional<Ellipsoid>& a, const std::optional<Ellipsoid>& b) {
    return a.has_value() == b.has_value() && (!a || same(*a, *b));
}

bool same(const TissueValues& a, const TissueValues& b) {
    return a.springConstant == b.springConstant && a.viscosity == b.viscosity && a.mass == b.mass;
}

bool same(const Path& a, const Path& b) {
    return sameList(
        a, b, [](const PathPoint& p, const PathPoint& q) { return p.time == q.time && p.value == q.value; });
}

bool same(const NodeSelection& a, const NodeSelection& b) {
    return a.nodes == b.nodes && same(a.ellipsoid, b.ellipsoid);
}

bool same(const TetherRule& a, const TetherRule& b) {
    return a.every == b.every && a.springConstant == b.springConstant && a.viscosity == b.viscosity;
}

bool same(const NodeForce& a, const NodeForce& b) {
    return a.node == b.node && a.force == b.force && a.from == b.from && a.to == b.to;
}

bool same(const NodeMove& a, const NodeMove& b) {
    return a.node == b.node && same(a.path, b.path);
}

bool same(const std::optional<InstrumentMotion>& a, const std::optional<InstrumentMotion>& b) {
    return a.has_value() == b.has_value() && (!a || (a->radius == b->radius && same(a->path, b->path)));
}

template<typename T> bool sameItems(const std::vector<T>& a, const std::vector<T>& b) {
    return sameList(a, b, [](const T& x, const T& y) { return same(x, y); });
}

bool same(const Scene& a, const Scene& b) {
    return a.duration == b.duration && a.gravity == b.gravity && sameItems(a.fixed, b.fixed) &&
           sameItems(a.tethers, b.tethers) && sameItems(a.forces, b.forces) && sameItems(a.moves, b.moves) &&
           same(a.instrument, b.instrument) && a.record.every == b.record.every &&
           a.record.nodes == b.record.nodes;
}

bool same(const TextureSettings& a, const TextureSettings& b) {
    return a.atlas.size == b.atlas.size && a.atlas.pages == b.atlas.pages && a.atlas.gap == b.atlas.gap &&
           a.atlas.layout == b.atlas.layout && a.atlas.texelsPerMetre == b.atlas.texelsPerMetre &&
           a.baseColour == b.baseColour;
}

bool same(const BaseTissue& a, const BaseTissue& b) {
    return a.springConstant == b.springConstant && a.viscosity == b.viscosity && a.mass == b.mass &&
           a.stiffening == b.stiffening;
}

} // namespace

bool same(const std::shared_ptr<const FuzzySystem>& a, const std::shared_ptr<const FuzzySystem>& b) {
    return a == b || (a && b && *a == *b);
}

bool same(const Region& a, const Region& b) {
    return a.name == b.name && a.colour == b.colour && sameReach(a, b) && same(a.system, b.system) &&
           a.inputs == b.inputs && same(a.held, b.held);
}

bool sameReach(const Region& a, const Region& b) {
    return same(a.ellipsoid, b.ellipsoid) && a.rim == b.rim;
}

bool same(const TextureLayer& a, const TextureLayer& b) {
    return a.name == b.name && a.photo == b.photo && a.projector == b.projector &&
           a.blendPixels == b.blendPixels && a.opacity == b.opacity && a.visible == b.visible &&
           a.preparation == b.preparation && a.blending == b.blending && a.strokes == b.strokes;
}

bool same(const Stepping& a, const Stepping& b) {
    return a.integrator == b.integrator && a.timeStep == b.timeStep && a.precision == b.precision;
}

bool same(const std::optional<MeasuredStepping>& a, const std::optional<MeasuredStepping>& b) {
    if (!a || !b) return a.has_value() == b.has_value();
    return same(a->stepping, b->stepping) && a->error == b->error &&
           a->wallPerSimulatedSecond == b->wallPerSimulatedSecond && a->tissue == b->tissue;
}

Change difference(const Project& before, const Project& after) {
    Change change;
    change.name = before.name != after.name;
    change.mesh = before.mesh != after.mesh || before.network != after.network ||
                  before.importReport != after.importReport;
    change.tissue = !same(before.base, after.base);
    change.regions = !sameItems(before.regions, after.regions);
    change.scene = !same(before.scene, after.scene);
    change.stepping = !same(before.stepping, after.stepping);
    change.layers = !sameItems(before.layers, after.layers);
    change.landmarks =
        !sameList(before.layers, after.layers,
                  [](const TextureLayer& a, const TextureLayer& b) { return a.landmarks == b.landmarks; });
    change.texture = !same(before.texture, after.texture) || before.atlas != after.atlas;
    return change;
}

} // namespace esm
