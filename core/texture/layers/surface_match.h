#pragma once

#include "core/texture/layers/surface_beneath.h"

namespace esm {

/// What gives a layer's photo the colours of the surface beneath it, as other layers make it. Nothing where
/// the photo meets too little of the surface. Precondition: the layer has a photo.
/// @param beneath from the lowest to the topmost: those below the layer
/// @throws Cancelled
std::optional<ColourMatch> matchToSurface(const TriangleMesh& mesh, const std::vector<TextureLayer>& beneath,
                                          std::array<std::uint8_t, 3> baseColour, const TextureLayer& layer,
                                          const Progress& progress = {});

} // namespace esm
