#pragma once

#include "core/render/renderer.h"

namespace esm {

/// The colour of a value between 0 and 1: blue, teal, yellow, red. Values outside take the colour of the
/// nearer end.
Colour rampColour(double share);

} // namespace esm
