#pragma once

#include "core/geometry/triangle_mesh.h"
#include "core/texture/projection/projector.h"

#include <cstdint>
#include <vector>

namespace esm {

/// Marks the triangles, not 0, of which it is certain that no other hides any point from the projector, so
/// that no ray needs to be followed there. Their views in the photo's plane are compared: a triangle is
/// certain when all whose views overlap its own lie behind it. Of triangles that reach behind a perspective
/// projector's eye nothing is certain, nor where such a one may hide others.
std::vector<std::uint8_t> certainlyLit(const TriangleMesh& mesh, const Projector& projector, PhotoSize photo);

} // namespace esm
