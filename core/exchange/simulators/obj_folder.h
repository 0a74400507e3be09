#pragma once

#include "core/exchange/simulators/difference.h"
#include "core/exchange/simulators/handover.h"

#include <filesystem>

namespace esm {

/// Writes an organ as a folder for whoever has a spreadsheet, a script or any 3-D program: `surface.obj` with
/// its material and pictures, and a table of each kind of thing as `springs.csv` and so on, described in
/// `docs/model-tables.md`. A model without surface is drawn by `network.obj`: its springs as lines, or its
/// nodes as points.
/// @param folder none of its name yet, or an empty one
/// @throws InvalidModel for pages that cannot be encoded; FileError, Cancelled
void writeObjFolder(const Handover& handover, const std::filesystem::path& folder,
                    const HandoverMeans& means);

/// What of how the surface looks is left out.
Differences objFolderDifferences(const Handover& handover, const HandoverMeans& means);

} // namespace esm
