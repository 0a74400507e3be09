#pragma once

#include "core/surface/surface_query.h"
#include "core/texture/layers/texture_layer.h"

namespace esm {

/// The lowest layer above another one that hides it all but wholly at a point of the surface, so that nothing
/// done to the other is seen there. Null where none does. Multiplying layers hide nothing.
/// @param surface of the organ, for projectors that colour only what they see
const TextureLayer* coveringLayer(const std::vector<TextureLayer>& layers, LayerId layer,
                                  const SurfacePoint& point, const SurfaceQuery& surface);

} // namespace esm
