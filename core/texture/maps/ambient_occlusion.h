#pragma once

#include "core/geometry/triangle_mesh.h"
#include "core/support/progress.h"
#include "core/texture/atlas/atlas.h"
#include "core/texture/image.h"

#include <vector>

namespace esm {

/// How much of the light from all around reaches the surface at rest: 255 where nothing stands in its way,
/// less in folds and between parts. What stands nearer takes more light, and nothing does from `reach` on: in
/// a hollow organ, whose far wall always stands in the way, folds are dark all the same and flat wall is not.
/// @param reach m, > 0 @return a grey picture of each page @throws Cancelled
std::vector<Image> occlusionPages(const TriangleMesh& mesh, const Atlas& atlas, double reach,
                                  const Progress& progress = {});

} // namespace esm
