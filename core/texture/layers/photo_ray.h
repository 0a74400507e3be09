#pragma once

#include "core/surface/surface_query.h"
#include "core/texture/projection/projector.h"

namespace esm {

/// The ray along which a projector casts a place of its photo, in pixels from the top left corner. Along its
/// direction, which is not normalised, depth grows by one metre.
Ray rayThrough(const Projector& projector, PhotoSize photo, const Eigen::Vector2d& pixel);

} // namespace esm
