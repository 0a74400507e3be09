#pragma once

#include "core/exchange/simulators/difference.h"
#include "core/exchange/simulators/handover.h"

#include <filesystem>

namespace esm {

/// Writes an organ as VTK's PolyData in XML, for ParaView and 3D Slicer: springs as lines and the drawn
/// surface as triangles over one list of points, the nodes first, then the vertices that nodes carry in other
/// places than their own. What is known of nodes and springs stands in arrays with their units; what is drawn
/// takes its tissue from the nodes that carry it. The rest of the model is in arrays of the whole, as
/// PolyData has no cells for it. Arrays are listed in `docs/command-line.md`.
/// @throws FileError, Cancelled
void writeVtp(const Handover& handover, const std::filesystem::path& file, const HandoverMeans& means);

/// The same as UnstructuredGrid, in which the tetrahedra of a filled organ are cells: what fills it can be
/// cut, sliced and coloured.
/// @throws FileError, Cancelled
void writeVtu(const Handover& handover, const std::filesystem::path& file, const HandoverMeans& means);

// What of an organ has no place in either of them.
Differences vtpDifferences(const Handover& handover, const HandoverMeans& means);
Differences vtuDifferences(const Handover& handover, const HandoverMeans& means);

} // namespace esm
