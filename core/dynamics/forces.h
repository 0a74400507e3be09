#pragma once

#include "core/dynamics/energy.h"
#include "core/dynamics/loads.h"
#include "core/dynamics/motion.h"
#include "core/dynamics/settings.h"
#include "core/dynamics/spring_system.h"

namespace esm {

/// Elastic forces of springs, c·(p1−p2)·(l/|p1−p2| − 1) on the first node [R 2.21] while they are linear, and
/// of tethers, −c·(p−p0), of hinges (hinge_force.h), and of fluids by their own stiffness, p·∂V/∂x; N, in
/// place of what `forces` held. A spring of zero length has no direction and gives none.
void elasticForces(const SpringSystem& system, const Vectors& positions, Vectors& forces);

/// Adds the damping of springs, −d·(v1−v2) on the first node, of tethers, −d·v, and of hinges. `Axial` takes
/// only the part of a spring's relative velocity along the spring; hinges it leaves as they are.
void addDampingForces(const SpringSystem& system, Damping damping, const Vectors& positions,
                      const Vectors& velocities, Vectors& forces);

/// Pa, what loads lay on a cavity beside its fluid's own pressure, so far through the step: 0 begin, 1 end.
double pressureOfLoads(const Loads& loads, const SpringSystem::Filled& cavity, double endShare);
/// Adds p·∂V/∂x of these pressures.
void addPressureOfLoads(const SpringSystem& system, const Loads& loads, double endShare,
                        const Vectors& positions, Vectors& forces);
/// Adds all that fluids press with: those pressures and the fluids' own.
void addFluidForces(const SpringSystem& system, const Loads& loads, double endShare, const Vectors& positions,
                    Vectors& forces);
/// J, what the loads' do, on the mean of the step, on the way from one place to another.
double workOfPressures(const SpringSystem& system, const Loads& loads, const Vectors& from,
                       const Vectors& to);

/// m³, of each cavity.
std::vector<double> volumesOf(const SpringSystem& system, const Vectors& positions);

/// N, what springs, hinges, tethers and fluids do to some nodes together: who holds them still bears it.
Eigen::Vector3d forceOn(const std::vector<std::uint32_t>& nodes, const SpringSystem& system, Damping damping,
                        const Motion& motion);

Energy energy(const SpringSystem& system, const Vectors& positions, const Vectors& velocities);
inline Energy energy(const SpringSystem& system, const Motion& motion) {
    return energy(system, motion.positions, motion.velocities);
}

} // namespace esm
