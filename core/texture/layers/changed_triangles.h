#pragma once

#include "core/texture/layers/layer_stack.h"
#include "core/texture/layers/page_painter.h"

namespace esm {

/// The triangles whose colours may differ between two lists of layers over the same base colour: all that a
/// changed layer reaches before or after, and what a clone or a blending in bands above makes of the change.
/// @throws Cancelled
TriangleMarks changedTriangles(const TriangleMesh& mesh, const std::vector<Patch>& patches,
                               const std::vector<TextureLayer>& before,
                               const std::vector<TextureLayer>& after, CompositionCache& cache,
                               const Progress& progress);

} // namespace esm
