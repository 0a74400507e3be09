#pragma once

#include "core/texture/finish/surface_finish.h"
#include "core/texture/image.h"
#include "core/texture/photo/photo_preparation.h"

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace esm {

/// What the colours of a finish mean: wetness as red and roughness as green, 0 to 1, and the height as blue,
/// from 1 for the least through 128 for none to 255 for the greatest.
using FinishColour = std::array<std::uint8_t, 3>;

/// Of a surface without relief.
FinishColour finishColour(const SurfaceFinish& finish);

/// How much of a film of fluid a photo's highlights add at every pixel of the projected picture, 0 to 255.
/// @param photo as it was taken, in which they are looked for
std::vector<std::uint8_t> filmOf(const Image& photo, const PhotoPreparation& preparation);

/// How high a photo's fine detail stands at every pixel of the projected picture, −127 to 127: at 64 it is
/// half as bright again as its surroundings, as high as a finish's relief says.
std::vector<std::int8_t> heightsOf(const Image& shown);

/// What a photo tells of any finish. Dear to find and the same whatever the finish says, so that it is kept.
struct FilmAndHeights {
    std::shared_ptr<const std::vector<std::uint8_t>> film;   ///< null where a finish asks for none
    std::shared_ptr<const std::vector<std::int8_t>> heights; ///< the same
};

/// A photo's finish as such colours for every pixel of the projected picture; alpha is that picture's.
/// @param found all that the finish asks for
/// @param greatestHeight m, that blue can say; above 0 where the finish has a relief
Image finishPicture(const Image& shown, const FilmAndHeights& found, const LayerFinish& finish,
                    double greatestHeight);

/// Whether a picture has detail from which a relief can be guessed; of one colour it has none.
bool hasDetail(const Image& shown);

} // namespace esm
