#pragma once

#include "core/exchange/simulators/difference.h"

namespace esm {

/// Of an organ that is handed over with damping along its springs alone.
inline Difference axialDifference() {
    return {"viscosity damps along the springs alone, and not all motion as here",
            "the organ gives way farther where it shears or turns"};
}

} // namespace esm
