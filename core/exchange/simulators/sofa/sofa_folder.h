#pragma once

#include "core/exchange/simulators/difference.h"
#include "core/exchange/simulators/handover.h"
#include "core/exchange/simulators/sofa/sofa_scene.h"

#include <filesystem>

namespace esm {

/// Writes an organ as a folder that SOFA loads as it is: `organ.scn` with nodes, springs, tethers, fixed
/// nodes and the scene's forces and led nodes, `damping.xsp` and `bending.xsp` with what only fits into files
/// of their own, and the drawn surface with its texture.
/// @throws FileError, Cancelled
void writeSofa(const Handover& handover, const std::filesystem::path& folder, const HandoverMeans& means);

/// The same with a scene that writes down how the organ moves in SOFA.
void writeRecordedSofa(const Handover& handover, const std::filesystem::path& folder,
                       const HandoverMeans& means, const SofaRecording& recording);

/// What SOFA does otherwise. @throws Cancelled
Differences sofaDifferences(const Handover& handover, const HandoverMeans& means);

} // namespace esm
