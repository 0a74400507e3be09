#pragma once

#include "core/model/detail.h"
#include "core/support/progress.h"

namespace esm {

/// The network of a surface at a level of detail. A surface that cannot be made as coarse as wanted has more
/// nodes.
/// @throws InvalidModel when fewer than 4 nodes or more than there are vertices are wanted, and as fillBody()
/// does; Cancelled
SpringNetwork networkOf(const TriangleMesh& mesh, const Detail& detail, const Progress& progress = {});

/// What makes an even sheet of a surface's network; nothing for what is filled or rigid, or has no triangles.
/// @throws Cancelled
std::optional<SheetShares> evenSheetOf(const TriangleMesh& mesh, const SpringNetwork& network,
                                       const Progress& progress = {});

} // namespace esm
