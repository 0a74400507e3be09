#pragma once

#include "core/geometry/simplified_mesh.h"
#include "core/support/progress.h"

namespace esm {

/// Leaves out vertices until `vertexCount` remain, first where the surface changes least (quadric error
/// metrics, meshoptimizer), but nowhere far more than elsewhere. Borders count more than what lies within;
/// every connected part keeps a triangle. Vertices at edges of more than two triangles stay, so that more
/// than asked for may remain. The same surface gives the same result.
/// @throws InvalidModel when fewer than 4 vertices or more than there are are asked for; Cancelled
SimplifiedMesh simplify(const TriangleMesh& mesh, std::size_t vertexCount, const Progress& progress = {});

} // namespace esm
