#pragma once

#include "core/exchange/simulators/difference.h"
#include "core/exchange/simulators/handover.h"

#include <filesystem>

namespace esm {

/// Writes an organ as Open Inventor 2.1 in ASCII, in metres, the format of the source's own tool [R 2.3.7]:
/// the drawn surface, textured where it has a texture, its pages within the file, and the spring-mass model
/// in a node of the type `EsmSpringMassModel`, which declares its fields, so that readers which do not know
/// it keep it. A model without surface shows its springs as lines, or its nodes as points. Described in
/// `docs/model-tables.md`.
/// @throws InvalidModel for numbers that 32-bit floats cannot hold; FileError, Cancelled
void writeInventor(const Handover& handover, const std::filesystem::path& file, const HandoverMeans& means);

/// What of how the surface looks is left out.
Differences inventorDifferences(const Handover& handover, const HandoverMeans& means);

} // namespace esm
