#pragma once

#include "core/project/tissue_preset.h"

namespace esm {

/// The shipped preset that a region's tissue was taken from, and that it still is; one with words before one
/// without. Without a region that of the organ's tethers. None where it is set otherwise.
std::optional<TissuePreset> presetInForce(const Project& project, const Region* region);

/// The same of the region that most of the tissue at a point (m, of the organ at rest) follows.
std::optional<TissuePreset> presetInForceAt(const Project& project, const Eigen::Vector3d& point);

} // namespace esm
