#include "core/exchange/simulators/sofa/sofa_release.h"

namespace esm {

SofaRelease releaseOf(SofaVersion version) {
    const bool isLate = version >= SofaVersion::December2024;
    const bool isNamedProjective = version >= SofaVersion::June2024;
    return {.version = version,
            .springField = isLate ? "SpringForceField" : "StiffSpringForceField",
            .fixedConstraint = isNamedProjective ? "FixedProjectiveConstraint" : "FixedConstraint",
            .movedConstraint =
                isNamedProjective ? "LinearMovementProjectiveConstraint" : "LinearMovementConstraint",
            .knowsPullingSprings = isLate,
            .solverAddsDamping = !isLate};
}

} // namespace esm
