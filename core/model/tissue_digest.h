#pragma once

#include "core/model/stepping.h"
#include "core/model/tissue_model.h"

namespace esm {

/// Sixteen hexadecimal digits (FNV-1a, 64 bits) of masses, spring constants, viscosities, rest lengths, the
/// springs' law and what they have of their own, in single precision as a model package holds them. Tethers
/// and fixed nodes do not count: they are the scene's.
std::string tissueDigest(const TissueModel& model);

/// Whether it was measured on other tissue than this. What does not say on which was not.
bool isFromOtherTissue(const MeasuredStepping& measured, const TissueModel& model);

} // namespace esm
