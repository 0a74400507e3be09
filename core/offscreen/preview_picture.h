#pragma once

#include "core/exchange/simulators/handover.h"

namespace esm {

/// The organ from the front, as people know it in a list of model packages; 512 × 512 pixels. The same
/// project gives the same picture, wherever it is drawn.
/// @throws std::runtime_error as renderOffscreen() does
Image previewPicture(const Project& project, const PackagePages& pages);

} // namespace esm
