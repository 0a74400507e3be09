#pragma once

namespace esm {

/// (hω)² must stay below this at h·d/m = stepDamping, or an oscillator grows under split2. The two branches
/// are where a root of the step leaves the unit circle in a complex pair and at −1; for little damping it is
/// √(2·h·d/m).
double split2Limit(double stepDamping);

} // namespace esm
