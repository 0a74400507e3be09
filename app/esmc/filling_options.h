#pragma once

#include "core/geometry/triangle_mesh.h"
#include "core/model/lattice.h"

#include <CLI/CLI.hpp>

#include <optional>
#include <string>

namespace esm {

/// What a body is to be filled with, as it is said on the command line.
struct FillingOptions {
    std::optional<LatticeKind> kind;     ///< none: nothing
    std::optional<double> spacing;       ///< m; none: such that there are some `usualLatticeNodes`
    std::optional<double> wallThickness; ///< of prisms, m; none: that of the organ's wall
    std::optional<int> layers;           ///< of prisms; none: `usualLayers()`
};

/// --fill, --spacing, --wall-thickness and --layers. @param without what no filling means
void declareFilling(CLI::App& command, FillingOptions& options, const std::string& without);

/// Nothing where nothing is to fill it.
/// @param wallThickness of prisms where nobody says it, m
/// @throws UsageError for a spacing of nothing or of prisms, and for a wall's measures of another filling;
/// InvalidModel as estimateLattice() does
std::optional<LatticeFilling> chosenFilling(const TriangleMesh& mesh, const FillingOptions& options,
                                            double wallThickness);

} // namespace esm
