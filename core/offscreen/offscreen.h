#pragma once

#include "core/render/renderer.h"

namespace esm {

inline constexpr int largestPictureSize = 8192; ///< pixels, width and height

/// A picture without a window, by OSMesa, its edges smoothed; the same scene gives the same picture. May be
/// called from any thread; calls wait for each other. The thread loses its current OpenGL context.
/// @throws InvalidModel when width or height is not between 1 and `largestPictureSize`
/// @throws std::runtime_error when no context can be made
Image renderOffscreen(const RenderScene& scene, const Camera& camera, int width, int height);

} // namespace esm
