#pragma once

#include "widgets/view/sight.h"

namespace esm {

/// Comes closer (factor < 1) to what is seen at a place of the view, or goes away from it, to so many times
/// the distance; the place shows the same point again. The eye never goes through the surface, and stays 0.4
/// % of the organ's size away from it; what is nearer already comes no nearer.
Camera approached(const Sight& sight, const QPointF& place, double factor);

/// The camera with its eye moved back until it is outside the surface around it, as far as the surface's
/// sides tell.
Camera outOfSurface(const Sight& sight);

} // namespace esm
