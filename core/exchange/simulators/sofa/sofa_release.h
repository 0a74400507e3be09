#pragma once

#include "core/exchange/simulators/sofa/sofa_version.h"

namespace esm {

/// What differs between releases of SOFA, as their sources have it.
struct SofaRelease {
    SofaVersion version;
    const char* springField;     ///< springs that are stiff in the solver's matrix
    const char* fixedConstraint; ///< of nodes that do not move
    const char* movedConstraint; ///< of nodes that are led
    /// A spring may say that it only pulls, of which biphasic springs are made.
    bool knowsPullingSprings;
    /// EulerImplicitSolver adds the damping that fields declare as Rayleigh damping to its right-hand side
    /// itself. Later ones leave that to the forces.
    bool solverAddsDamping;
};
SofaRelease releaseOf(SofaVersion version);

} // namespace esm
