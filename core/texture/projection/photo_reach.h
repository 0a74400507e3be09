#pragma once

#include "core/geometry/triangle_mesh.h"
#include "core/texture/projection/projector.h"

namespace esm {

/// Whether a photo may fall on a surface, by the boxes around its triangles in the photo. Where this is
/// false, no point of the surface takes colour from it.
bool mayMeet(const Projector& projector, PhotoSize photo, const TriangleMesh& mesh);

} // namespace esm
