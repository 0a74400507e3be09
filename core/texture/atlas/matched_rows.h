#pragma once

#include "core/texture/atlas/row_layout.h"

namespace esm {

/// Rows of triangles as layoutRows, but each next patch is chosen, out of the tallest that wait, and mirrored
/// where that helps, so that its slant runs along that of the patch before it. The shapes come tallest first.
/// Every patch keeps the gap to all others.
PatchLayout layoutMatchedRows(const std::vector<PatchShape>& shapes, double texelsPerMetre,
                              const PageRoom& page, const Progress& progress = {});

} // namespace esm
