#pragma once

#include "core/dynamics/statics/pressed_tissue.h"
#include "core/probing/probe.h"

namespace esm {

struct PlacedIndenter {
    Indenter indenter;     ///< at depth 0 it just touches
    Eigen::Vector3d place; ///< m, on the surface
    double thickness; ///< m, of what can be pressed in beneath; infinite where the line meets no second side
};

/// Sets a finger onto the organ at rest.
/// @param isImmovable per node
/// @throws InvalidModel for a place off the surface, a direction out of the organ, or tissue that cannot give
/// way
PlacedIndenter placedIndenter(const ProbedOrgan& organ, const std::vector<char>& isImmovable,
                              const ProbeSettings& settings);

} // namespace esm
