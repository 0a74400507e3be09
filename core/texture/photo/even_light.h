#pragma once

#include "core/texture/image.h"

namespace esm {

/// Takes slow changes of brightness over the photo away, `strength` 0 (none) to 1 (all), and leaves the photo
/// as bright on the whole as it was. Only pixels with alpha that are not nearly black count, so that a dark
/// outside does not brighten the rim; no pixel becomes more than three times as bright or as dark.
void evenLight(Image& photo, double strength);

} // namespace esm
