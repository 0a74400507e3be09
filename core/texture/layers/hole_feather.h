#pragma once

#include "core/support/progress.h"
#include "core/texture/image.h"
#include "core/texture/layers/photo_fade.h"

namespace esm {

/// Fades a photo out towards what is wholly transparent of it, as what lies outside its field, was erased or
/// cropped: linearly over `blendPixels`, as towards its sides [R 4.3.3].
/// @throws Cancelled
PhotoFade holeFeather(const Image& photo, double blendPixels, const Progress& progress = {});

} // namespace esm
