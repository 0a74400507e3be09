#pragma once

#include <algorithm>

namespace esm {

/// 0 at `from` and before it, 1 at `to` and beyond, without a kink between, as 3t² − 2t³. `from` may be the
/// larger; they differ.
inline double smoothStep(double from, double to, double value) {
    const double t = std::clamp((value - from) / (to - from), 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

} // namespace esm
