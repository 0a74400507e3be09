#pragma once

#include "core/geometry/triangle_mesh.h"
#include "core/model/lattice.h"

#include <CLI/CLI.hpp>

#include <optional>
#include <string>

namespace esm {

/// What a body is to be filled with, as it is said on the command line.
struct FillingOptions {
    std::optional<LatticeKind> kind; ///< none: nothing
    std::optional<double> spacing;   ///< m; none: such that there are some `usualLatticeNodes`
};

/// --fill and --spacing. @param without what no filling means
void declareFilling(CLI::App& command, FillingOptions& options, const std::string& without);

/// Nothing where nothing is to fill it. @throws UsageError for a spacing of nothing; InvalidModel as
/// estimateLattice() does
std::optional<LatticeFilling> chosenFilling(const TriangleMesh& mesh, const FillingOptions& options);

} // namespace esm
