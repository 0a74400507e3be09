#pragma once

#include "core/dynamics/spectrum/stability_search.h"
#include "core/dynamics/spectrum/symmetric_sum.h"
#include "core/dynamics/spring_system.h"

namespace esm {

/// What fluids add to the stiffness of a tissue at rest, over the coordinates x, y, z of the nodes that are
/// not fixed, three rows each in the order of the nodes: σ·g·gᵀ by their own stiffness, and −p·∂g/∂x by how
/// the largest pressures of loads turn with their walls, which is sparse and may be negative. For any
/// deformation both are taken as of walls that have grown.
SymmetricSum fluidStiffness(const SpringSystem& system, Deformation deformation);

/// The same matrix for x, y and z, three rows in place of each. Lower halves.
Eigen::SparseMatrix<double> forThreeAxes(const Eigen::SparseMatrix<double>& lower);

} // namespace esm
