#pragma once

#include "core/authoring/baked_pages.h"

namespace esm {

/// The organ from the front, as people know it in a list of model packages; 512 × 512 pixels. The same
/// project gives the same picture, wherever it is drawn.
/// @throws std::runtime_error as renderOffscreen() does
Image previewPicture(const Project& project, const BakedPages& pages);

} // namespace esm
