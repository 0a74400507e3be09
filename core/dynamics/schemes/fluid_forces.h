#pragma once

#include "core/dynamics/forces.h"
#include "core/dynamics/kernel/tissue_kernel.h"

namespace esm {

/// The forces of fluids on the states of a kernel, in its order of nodes. Without cavities it does nothing.
/// They are computed in double precision, of floats too: a volume is a small difference of large sums.
template<class Real> class FluidForces {
public:
    using State = typename TissueKernel<Real>::State;

    /// @param team outlives this; null is one thread
    FluidForces(const SpringSystem& system, const TissueKernel<Real>& kernel, ThreadTeam* team);

    /// Takes new parameters, cavities and masses. Precondition: as of the kernel.
    void setParameters(const SpringSystem& system, const TissueKernel<Real>& kernel);

    /// Calls `visit(row, inverse mass in 1/kg, force in N)` for each node of each wall, in their order.
    /// @param share of the step's time that has passed at the state
    template<class Visit>
    void forEach(const Loads& loads, double share, const State& at, const Visit& visit) {
        for (const Filled& filled : m_filled) {
            if (filled.cavity.stiffness == 0 && loads.pressures.empty()) continue;
            const auto [volume, gradient] = volumeAt(filled, at);
            const double pressure =
                ownPressure(filled.cavity, volume) + pressureOfLoads(loads, filled.cavity, share);
            for (std::size_t place = 0; place < gradient.size(); ++place)
                visit(filled.nodes[place].row, filled.nodes[place].inverseMass, pressure * gradient[place]);
        }
    }

private:
    struct Node {
        std::size_t row;
        double inverseMass; ///< 1/kg; 0 when it is fixed
    };
    struct Filled {
        SpringSystem::Filled cavity;
        std::vector<Node> nodes; ///< by place
    };

    CavityVolume volumeAt(const Filled& filled, const State& state) const;

    std::vector<Filled> m_filled;
    ThreadTeam* m_team;
};

extern template class FluidForces<float>;
extern template class FluidForces<double>;

} // namespace esm
