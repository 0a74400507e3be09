#pragma once

#include "core/dynamics/spring_system.h"

#include <string>
#include <vector>

namespace esm {

/// A spring of SOFA's VectorSpringForceField: it pulls its ends to a vector between them, whichever way that
/// points, and damps all of their relative velocity.
struct VectorSpring {
    std::uint32_t first, second;
    double springConstant; ///< N/m
    double viscosity;      ///< N·s/m
};

/// Hinges as such springs between their nodes: six of constants −κ·wᵢ·wⱼ each, with the weights w of its
/// bars (HingeShape), and viscosities alike. Their sum is κ·w·wᵀ, which is the hinge exactly where it is flat
/// at rest.
std::vector<VectorSpring> hingeSprings(const SpringSystem& system);

/// The network's springs as such ones, of their viscosity alone: what damps isotropically.
std::vector<VectorSpring> viscousSprings(const SpringSystem& system);

/// The file that VectorSpringForceField loads (Xsp, version 4.0): the nodes in their order, then the springs,
/// each with the vector between its ends at rest.
std::string xspText(const std::vector<VectorSpring>& springs,
                    const std::vector<Eigen::Vector3d>& restPositions);

} // namespace esm
