#pragma once

#include <algorithm>

namespace esm {

/// 0 up to `from`, 1 beyond `to` and without a kink between, as 3t² − 2t³. Precondition: from < to.
inline double smoothStep(double from, double to, double value) {
    const double t = std::clamp((value - from) / (to - from), 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

} // namespace esm
