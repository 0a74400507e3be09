#pragma once

#include "core/texture/photo/photo.h"
#include "core/texture/photo/photo_preparation.h"
#include "core/texture/projection/projector.h"

#include <memory>
#include <string>

namespace esm {

/// A photo on the organ. Never baked in: layers are composed anew when one changes.
struct TextureLayer {
    std::string name;
    std::shared_ptr<const Photo> photo; ///< never null
    Projector projector;
    double blendPixels = 24; ///< photo pixels over which the weight rises from 0 at the border to 1 [R 4.3.3]
    double opacity = 1;      ///< 0 to 1
    bool visible = true;
    PhotoPreparation preparation;
    std::shared_ptr<const Image> prepared; ///< what it makes of the photo; null where it does nothing
};

/// What the projector throws: the prepared picture, or the photo's own.
std::shared_ptr<const Image> pictureOf(const TextureLayer& layer);

/// Gives a layer another preparation and the picture that comes of it, or leaves it as it was.
/// @throws InvalidModel with what validate() finds
void prepare(TextureLayer& layer, const PhotoPreparation& preparation);

} // namespace esm
