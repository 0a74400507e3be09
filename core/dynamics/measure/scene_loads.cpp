#include "core/dynamics/measure/scene_loads.h"

#include <algorithm>

namespace esm {

namespace {

/// The part of a step during which a force acts. The mean of a force over a step gives the tissue the same
/// momentum as the force, however short it is. What rounding leaves of a long force at the border of a step
/// is taken for none: else a step without a load would have one.
double shareOf(const NodeForce& force, double start, double end) {
    constexpr double rounding = 1e-9;
    const double duration = end - start;
    const double overlap = std::min(force.to, end) - std::max(force.from, start);
    if (overlap <= 0) return 0;
    if (force.to - force.from < duration) return overlap / duration;
    if (overlap < rounding * duration) return 0;
    return overlap > (1 - rounding) * duration ? 1 : overlap / duration;
}

} // namespace

Loads loadsDuring(const Scene& scene, const std::vector<Eigen::Vector3d>& rest, double start, double end) {
    Loads loads;
    loads.gravity = scene.gravity;
    for (const NodeForce& force : scene.forces)
        if (const double share = shareOf(force, start, end); share > 0 && force.node < rest.size())
            loads.forces.emplace_back(force.node, share * force.force);
    for (const NodeMove& move : scene.moves)
        if (move.node < rest.size())
            loads.prescribed.push_back({move.node, rest[move.node] + positionAt(move.path, end)});
    for (const PartPressure& pressure : scene.pressures)
        loads.pressures.push_back({pressure.part, pressureAt(pressure, start), pressureAt(pressure, end)});
    for (const InstrumentMotion& instrument : scene.instruments)
        loads.instruments.push_back(placedAt(instrument, end));
    return loads;
}

} // namespace esm
