#pragma once

#include "app/esmc/report.h"
#include "core/dynamics/stability/stability.h"

namespace esm {

/// "0.01 s", "no limit", "none is stable"
std::string stepInText(const std::optional<double>& step);

/// Seconds by integrator, null where there is no limit or no stable step; `note` says which.
Json stepsInJson(const CriticalSteps& steps);

} // namespace esm
