#pragma once

#include "core/dynamics/block_entries.h"
#include "core/dynamics/hinge_force.h"
#include "core/dynamics/matrix_factors.h"

namespace esm {

/// Whether a hinge's tangent has what the strain that there is adds to it, which may make it indefinite.
enum class HingeTangent { WithStrain, WithoutStrain };

/// Adds a hinge's share of dampingFactor·D + stiffnessFactor·K at these positions, m: twelve rows and
/// columns.
void addHinge(const SpringSystem::HingeElement& hinge, const Vectors& positions, HingeTangent tangent,
              const MatrixFactors& factors, BlockEntries& entries);

} // namespace esm
