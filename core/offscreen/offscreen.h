#pragma once

#include "core/render/renderer.h"

namespace esm {

/// A picture without a window, by OSMesa. @throws std::runtime_error when no context can be made
Image renderOffscreen(const RenderScene& scene, const Camera& camera, int width, int height);

} // namespace esm
