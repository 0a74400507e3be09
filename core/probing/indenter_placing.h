#pragma once

#include "core/dynamics/statics/pressed_tissue.h"
#include "core/probing/probe.h"
#include "core/surface/surface_query.h"

namespace esm {

/// An organ before a finger comes.
struct StandingOrgan {
    const ProbedOrgan& organ;
    const Vectors& positions;             ///< m, of its nodes, at rest under the pressures within
    const std::vector<char>& isImmovable; ///< per node
};

struct PlacedIndenter {
    Indenter indenter; ///< at depth 0 it just touches
    double thickness;  ///< m, of what can be pressed in beneath; infinite where the line meets no second side
};

/// Sets a finger onto an organ, over a place of its surface as it stands there.
/// @throws InvalidModel for a direction out of the organ, or tissue that cannot give way
PlacedIndenter placedIndenter(const StandingOrgan& standing, const RayHit& place,
                              const ProbeSettings& settings);

} // namespace esm
