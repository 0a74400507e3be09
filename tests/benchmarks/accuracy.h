#pragma once

#include "core/dynamics/measure/motion_error.h"
#include "core/dynamics/simulation.h"
#include "core/dynamics/spring_system.h"

namespace benchmarks {

/// Tissue at rest that a force pulls at one node from the start.
struct PulledTissue {
    esm::TissueModel model;
    std::uint32_t node;
    Eigen::Vector3d force; ///< N
    double seconds;
};

/// A membrane of 37 × 37 nodes, held at its rim and pulled at its middle, whose largest angular frequency is
/// given, rad/s. Damping in parts of that: damping·K/ω².
PulledTissue pulledMembrane(double largestFrequency, double damping, const Eigen::Vector3d& force,
                            double seconds);

inline constexpr int frameCount = 20; ///< of a trajectory after its start, at even times, the last at the end

/// Of a number of steps that is a multiple of the frames. Shorter where it went astray.
esm::Trajectory trajectoryOf(const PulledTissue& tissue, esm::Integrator integrator, int steps);

/// Relative to the motion of the reference; infinite where the trajectory found is shorter.
double errorOf(const esm::Trajectory& found, const esm::Trajectory& reference);

/// Fewest steps, of the frames times a power of two, with which the error is at most so much.
/// @throws std::runtime_error where a hundred thousand steps are not enough
int fewestSteps(const PulledTissue& tissue, esm::Integrator integrator, double mostError,
                const esm::Trajectory& reference);

} // namespace benchmarks
