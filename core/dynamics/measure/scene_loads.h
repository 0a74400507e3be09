#pragma once

#include "core/dynamics/loads.h"
#include "core/model/scene.h"

namespace esm {

class Simulation;

/// What pressures are at a step's two ends, s.
std::vector<CavityPressure> pressuresDuring(const std::vector<PartPressure>& pressures, double start,
                                            double end);

/// Simulation::advance() under pressures that take their course with its time, in place of those of the
/// loads.
std::size_t advancePressed(Simulation& simulation, Loads loads, const std::vector<PartPressure>& pressures,
                           std::size_t count);

/// The scene's loads during a step from `start` to `end`, s: each force's mean over it, and where what is led
/// is at its end. `rest` are the nodes' rest positions, m.
Loads loadsDuring(const Scene& scene, const std::vector<Eigen::Vector3d>& rest, double start, double end);

} // namespace esm
