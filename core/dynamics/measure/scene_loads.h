#pragma once

#include "core/dynamics/loads.h"
#include "core/model/scene.h"

namespace esm {

/// The scene's loads during a step from `start` to `end`, s: each force's mean over it, and where what is led
/// is at its end. `rest` are the nodes' rest positions, m.
Loads loadsDuring(const Scene& scene, const std::vector<Eigen::Vector3d>& rest, double start, double end);

} // namespace esm
