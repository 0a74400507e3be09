#pragma once

#include "core/exchange/simulators/difference.h"
#include "core/exchange/simulators/handover.h"

#include <filesystem>

namespace esm {

/// Writes an organ as a folder that MuJoCo loads as it is: `organ.xml`, see `mujocoModelText()`, and the
/// pictures of its texture.
/// @throws InvalidModel with the reason for an organ that is too large, or that MuJoCo cannot hold;
/// FileError, Cancelled
void writeMujoco(const Handover& handover, const std::filesystem::path& folder, const HandoverMeans& means);

/// What MuJoCo does otherwise; why it is not handed over where it cannot be. @throws Cancelled
Differences mujocoDifferences(const Handover& handover, const HandoverMeans& means);

} // namespace esm
