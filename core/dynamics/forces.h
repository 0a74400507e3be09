#pragma once

#include "core/dynamics/energy.h"
#include "core/dynamics/motion.h"
#include "core/dynamics/settings.h"
#include "core/dynamics/spring_system.h"

namespace esm {

/// Elastic forces of springs, c·(p1−p2)·(l/|p1−p2| − 1) on the first node [R 2.21] while they are linear, and
/// of tethers, −c·(p−p0), and of hinges (hinge_force.h); N, in place of what `forces` held. A spring of zero
/// length has no direction and gives none.
void elasticForces(const SpringSystem& system, const Vectors& positions, Vectors& forces);

/// Adds the damping of springs, −d·(v1−v2) on the first node, of tethers, −d·v, and of hinges. `Axial` takes
/// only the part of a spring's relative velocity along the spring; hinges it leaves as they are.
void addDampingForces(const SpringSystem& system, Damping damping, const Vectors& positions,
                      const Vectors& velocities, Vectors& forces);

/// N, what springs, hinges and tethers do to some nodes together: who holds them still bears it.
Eigen::Vector3d forceOn(const std::vector<std::uint32_t>& nodes, const SpringSystem& system, Damping damping,
                        const Motion& motion);

Energy energy(const SpringSystem& system, const Vectors& positions, const Vectors& velocities);
inline Energy energy(const SpringSystem& system, const Motion& motion) {
    return energy(system, motion.positions, motion.velocities);
}

} // namespace esm
