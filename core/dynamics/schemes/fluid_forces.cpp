#include "core/dynamics/schemes/fluid_forces.h"

namespace esm {

template<class Real>
FluidForces<Real>::FluidForces(const SpringSystem& system, const TissueKernel<Real>& kernel, ThreadTeam* team)
    : m_team(team) {
    setParameters(system, kernel);
}

template<class Real>
void FluidForces<Real>::setParameters(const SpringSystem& system, const TissueKernel<Real>& kernel) {
    m_filled.clear();
    for (const SpringSystem::Filled& cavity : system.cavities) {
        Filled& filled = m_filled.emplace_back(Filled{cavity, {}});
        for (const std::uint32_t node : cavity.wall->nodes)
            filled.nodes.push_back({kernel.rowOf(node), double(kernel.inverseMass(node))});
    }
}

template<class Real>
CavityVolume FluidForces<Real>::volumeAt(const Filled& filled, const State& state) const {
    Vectors places;
    places.reserve(filled.nodes.size());
    for (const Node& node : filled.nodes) {
        const auto& position = state[node.row].position;
        places.emplace_back(position[0], position[1], position[2]);
    }
    return volumeOf(*filled.cavity.wall, places, m_team);
}

template class FluidForces<float>;
template class FluidForces<double>;

} // namespace esm
