#include "core/texture/layers/texture_layer.h"

namespace esm {

std::shared_ptr<const Image> pictureOf(const TextureLayer& layer) {
    if (layer.prepared) return layer.prepared;
    return {layer.photo, &layer.photo->image}; // the photo owns both
}

void prepare(TextureLayer& layer, const PhotoPreparation& preparation) {
    std::shared_ptr<const Image> picture;
    if (!preparation.isNothing())
        picture = std::make_shared<const Image>(prepared(layer.photo->image, preparation));
    layer.preparation = preparation;
    layer.prepared = std::move(picture);
}

} // namespace esm
