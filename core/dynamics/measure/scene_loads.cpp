#include "core/dynamics/measure/scene_loads.h"

#include "core/dynamics/simulation.h"

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

std::vector<CavityPressure> pressuresDuring(const std::vector<PartPressure>& pressures, double start,
                                            double end) {
    std::vector<CavityPressure> during;
    during.reserve(pressures.size());
    for (const PartPressure& pressure : pressures)
        during.push_back({pressure.part, pressureAt(pressure, start), pressureAt(pressure, end)});
    return during;
}

std::size_t advancePressed(Simulation& simulation, Loads loads, const std::vector<PartPressure>& pressures,
                           std::size_t count) {
    const std::size_t together = std::all_of(pressures.begin(), pressures.end(), isConstant) ? count : 1;
    std::size_t taken = 0;
    while (taken < count) {
        const double begin = simulation.time();
        loads.pressures = pressuresDuring(pressures, begin, begin + simulation.timeStep());
        const std::size_t steps = simulation.advance(loads, together);
        taken += steps;
        if (steps < together) break;
    }
    return taken;
}

Loads loadsDuring(const Scene& scene, const std::vector<Eigen::Vector3d>& rest, double start, double end) {
    Loads loads;
    loads.gravity = scene.gravity;
    for (const NodeForce& force : scene.forces)
        if (const double share = shareOf(force, start, end); share > 0 && force.node < rest.size())
            loads.forces.emplace_back(force.node, share * force.force);
    for (const NodeMove& move : scene.moves)
        if (move.node < rest.size())
            loads.prescribed.push_back({move.node, rest[move.node] + positionAt(move.path, end)});
    loads.pressures = pressuresDuring(scene.pressures, start, end);
    for (const InstrumentMotion& instrument : scene.instruments)
        loads.instruments.push_back(placedAt(instrument, end));
    return loads;
}

} // namespace esm
