#pragma once

#include "core/support/progress.h"
#include "core/texture/layers/texture_layer.h"

#include <memory>
#include <string>
#include <vector>

namespace esm {

/// Whether one photo is the other in another size, to within a pixel.
bool haveOneShape(const Image& a, const Image& b);

/// A layer with another photo in the place of its own, prepared in the same way. What is counted in pixels of
/// the photo (field, mask, crop, lens, landmarks, blending width, a known camera) is scaled by the ratio of
/// the heights, about the middles: the new photo keeps its height and its middle on the organ, and one of
/// another shape shows more or less at its sides. The layer's name follows the file where it was the file's.
/// Preconditions: the layer has a photo, and the other has pixels.
/// @throws InvalidModel where the photo cannot be prepared like that, Cancelled
TextureLayer withPhoto(const TextureLayer& layer, std::shared_ptr<const Photo> photo,
                       const Progress& progress = {});

/// What is to be looked at after that, in sentences; none for the same shot in another size.
std::vector<std::string> replacementRemarks(const TextureLayer& before, const TextureLayer& after);

} // namespace esm
