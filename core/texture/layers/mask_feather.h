#pragma once

#include "core/support/progress.h"
#include "core/texture/image.h"
#include "core/texture/layers/photo_fade.h"

namespace esm {

/// Fades a photo out towards what is masked, wholly transparent: what lies outside its field, was erased or
/// cropped. Linearly over `blendPixels`, as towards its sides [R 4.3.3].
/// @throws Cancelled
PhotoFade maskFeather(const Image& photo, double blendPixels, const Progress& progress = {});

} // namespace esm
