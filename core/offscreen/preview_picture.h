#pragma once

#include "core/project/project.h"
#include "core/texture/image.h"

#include <memory>
#include <vector>

namespace esm {

/// The organ from the front, as people know it in a list of model packages; 512 × 512 pixels. The same
/// project gives the same picture, wherever it is drawn.
/// @param pages of the project's atlas; null without a texture
/// @throws std::runtime_error as renderOffscreen() does
Image previewPicture(const Project& project, const std::shared_ptr<const std::vector<Image>>& pages);

} // namespace esm
