#pragma once

#include "app/editor/workers/poke_motion.h"
#include "core/render/renderer.h"

namespace esm {

/// The organ as it is shown, but as it moved at a time, s. What is painted for another net is left out.
RenderScene sceneAt(const RenderScene& shown, const PokeMotion& motion, double time);

} // namespace esm
