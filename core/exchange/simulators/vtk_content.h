#pragma once

#include "core/exchange/simulators/handover.h"
#include "core/exchange/simulators/vtk_xml.h"

namespace esm {

/// Cells of one kind, as VTK lists them.
struct VtkCells {
    std::vector<std::int64_t> points, ends; ///< one cell after the other; where each ends
};

enum class VtkVolumes { No, Yes };

/// An organ as VTK lists it. Points are the nodes, then the drawn vertices that are not at theirs. Arrays of
/// cells go through all single points, then lines, triangles and tetrahedra.
struct VtkContent {
    VtkArray places; ///< of the points, m
    VtkCells single, lines, triangles, tetrahedra;
    std::vector<VtkArray> ofPoints, ofCells;
    std::vector<VtkArray> ofAll; ///< what is neither of points nor of cells
};

/// @param volumes whether the format has cells for tetrahedra, which else stand in an array of nodes
/// @throws Cancelled
VtkContent vtkContentOf(const Handover& handover, VtkVolumes volumes, const Progress& progress);

} // namespace esm
