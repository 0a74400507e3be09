#pragma once

#include "core/render/renderer.h"

namespace esm {

/// The colour of a value between 0 and 1, from blue over green to yellow: lighter throughout, by equal steps
/// to the eye, and told apart by people who do not tell red from green. Values outside take the colour of the
/// nearer end.
Colour rampColour(double share);

} // namespace esm
