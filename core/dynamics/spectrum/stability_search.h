#pragma once

#include "core/support/progress.h"

#include <limits>

namespace esm {

inline constexpr double noStepLimit = std::numeric_limits<double>::infinity(); ///< s

/// Which deformations a step is to be stable at: close to rest, or any, where elasticity is bounded by its
/// weighted graph Laplacian.
enum class Deformation { AtRest, Any };

struct StabilitySearch {
    double tolerance = 1e-3; ///< relative; a step is found too short by at most this
    Deformation deformation = Deformation::Any;
    Progress progress; ///< asked at every step that is tried; how many there will be is not known
};

} // namespace esm
