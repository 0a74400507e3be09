#include "core/dynamics/schemes/moving_fluids.h"

#include "core/dynamics/forces.h"

#include <utility>

namespace esm {

MovingFluids::MovingFluids(const SpringSystem& system, const Loads& loads, const Vectors& positions)
    : m_at(system.cavities.empty() ? 0 : positions.size()) {
    for (const SpringSystem::Filled& cavity : system.cavities) {
        const CavityWall& wall = *cavity.wall;
        for (std::uint32_t place = 0; place < wall.size(); ++place)
            m_at[wall.nodes[place]] = {static_cast<std::uint32_t>(m_fluids.size()), place};
        Vectors places = placesOf(wall, positions);
        const double volume = volumeOf(wall, places).volume;
        m_fluids.push_back({&cavity, std::move(places), volume, pressureOfLoads(loads, cavity, 1)});
    }
}

MovingFluids::Push MovingFluids::on(std::uint32_t node) const {
    if (isDry(node)) return {};
    const Fluid& fluid = m_fluids[m_at[node].fluid];
    const Eigen::Vector3d gradient = volumeGradientAt(*fluid.cavity->wall, fluid.places, m_at[node].place);
    return {(ownPressure(*fluid.cavity, fluid.volume) + fluid.load) * gradient,
            pressureSlope(*fluid.cavity) * gradient.squaredNorm()};
}

void MovingFluids::move(std::uint32_t node, const Eigen::Vector3d& position) {
    if (isDry(node)) return;
    const auto [number, place] = m_at[node];
    Fluid& fluid = m_fluids[number];
    const Eigen::Vector3d gradient = volumeGradientAt(*fluid.cavity->wall, fluid.places, place);
    fluid.volume += gradient.dot(position - std::exchange(fluid.places[place], position));
}

} // namespace esm
