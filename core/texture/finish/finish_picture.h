#pragma once

#include "core/support/progress.h"
#include "core/texture/finish/surface_finish.h"
#include "core/texture/image.h"
#include "core/texture/photo/photo_preparation.h"

#include <array>

namespace esm {

/// What the colours of a finish mean: wetness as red and roughness as green, 0 to 1, and the height as blue,
/// from 1 for the least through 128 for none to 255 for the greatest.
using FinishColour = std::array<std::uint8_t, 3>;

/// Of a surface without relief.
FinishColour finishColour(const SurfaceFinish& finish);

/// A photo's finish as such colours for every pixel of the projected picture; alpha is that picture's.
/// @param photo as it was taken, in which highlights are looked for; prepared, `shown` comes of it
/// @param greatestHeight m, that blue can say; above 0 where the finish has a relief
/// @throws Cancelled
Image finishPicture(const Image& photo, const PhotoPreparation& preparation, const Image& shown,
                    const LayerFinish& finish, double greatestHeight, const Progress& progress = {});

/// Whether a picture has detail from which a relief can be guessed; of one colour it has none.
bool hasDetail(const Image& shown);

} // namespace esm
