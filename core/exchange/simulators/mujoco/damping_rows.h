#pragma once

#include "core/dynamics/spring_system.h"

#include <vector>

namespace esm {

/// A weighted sum of the velocities of some nodes, along one axis, that is damped.
struct DampingRow {
    double viscosity;                 ///< N·s/m
    std::vector<std::uint32_t> nodes; ///< that move, ascending
    std::vector<double> coefficients; ///< as many
};

/// What springs damp isotropically, in as few rows as there are nodes. With D the matrix of their viscosities
/// between nodes that move, the same for x, y and z, the rows r and their viscosities Δ make
///
///   D = Σ Δ·r·rᵀ,
///
/// its factors L·Δ·Lᵀ. One row a spring would do as well, and there are three times as many springs.
/// @param still by node, whether it stands where it is: it has no place in the rows
/// @throws InvalidModel where viscosities differ by so much that there are no factors
std::vector<DampingRow> dampingRows(const SpringSystem& system, const std::vector<char>& still);

} // namespace esm
