#pragma once

#include "core/dynamics/settings.h"
#include "core/dynamics/step_matrix.h"

namespace esm {

/// massFactor·M + dampingFactor·D + stiffnessFactor·K at rest over the coordinates x, y, z of the nodes that
/// are not fixed, three rows each in the order of the nodes; lower half. At rest a spring is stiff along its
/// axis alone.
Eigen::SparseMatrix<double> restMatrix(const SpringSystem& system, Damping damping,
                                       const MatrixFactors& factors);

} // namespace esm
