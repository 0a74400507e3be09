#pragma once

#include "core/dynamics/loads.h"
#include "core/dynamics/spring_system.h"

namespace esm {

/// Fluids while nodes move one after the other. A volume is linear in each single node's place, so that it is
/// kept up to date by its gradient there, and each node meets the pressure that the last one left.
class MovingFluids {
public:
    /// Those of a system that outlives this, under the loads at a step's end.
    MovingFluids(const SpringSystem& system, const Loads& loads, const Vectors& positions);

    /// What a fluid does to one node.
    struct Push {
        Eigen::Vector3d force = Eigen::Vector3d::Zero(); ///< N
        double stiffness = 0;                            ///< N/m, by which it falls as the node gives way
    };
    Push on(std::uint32_t node) const;

    void move(std::uint32_t node, const Eigen::Vector3d& position);

private:
    struct Fluid {
        const SpringSystem::Filled* cavity;
        Vectors places; ///< m
        double volume;  ///< m³
        double load;    ///< Pa, of loads
    };
    struct At {
        std::uint32_t fluid = noIndex, place = 0;
    };

    bool isDry(std::uint32_t node) const { return m_at.empty() || m_at[node].fluid == noIndex; }

    std::vector<Fluid> m_fluids;
    std::vector<At> m_at; ///< per node; empty without fluids
};

} // namespace esm
