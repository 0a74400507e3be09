#pragma once

#include "core/surface/surface_query.h"
#include "core/texture/layers/lit_triangles.h"
#include "core/texture/layers/photo_fade.h"

namespace esm {

/// Fades a photo out towards every outline over `blendPixels`, from either side: there the surface turns away
/// or ends before other surface, and the photo would end with a step along the edges of triangles.
/// @throws Cancelled
PhotoFade outlineFeather(const ShadowCaster& surface, const SurfaceQuery& query, const Projector& projector,
                         PhotoSize photo, double blendPixels, const Progress& progress = {});

} // namespace esm
