#pragma once

#include "core/texture/layers/brush_stroke.h"
#include "widgets/view/sight.h"

#include <optional>
#include <vector>

namespace esm {

/// The surface in the picture's place, seen from its outside; nothing beside it.
std::optional<BrushPoint> brushPointAt(const Sight& sight, const QPointF& place);

/// A place on a way of the mouse.
struct WayPoint {
    std::optional<BrushPoint> point; ///< nothing where the way leaves the surface, or goes over an edge to
                                     ///< one that lies further behind
    double share;                    ///< of the way, 0 to 1
};

/// The surface under a straight way of the mouse, without the place where it begins: points at most `spacing`
/// (m) from one to the next where that is one surface.
std::vector<WayPoint> brushPointsAlong(const Sight& sight, const QPointF& from, const QPointF& to,
                                       double spacing);

/// Whether surface is seen within a few pixels: who begins there to paint has just missed it.
bool isNearSurface(const Sight& sight, const QPointF& place);

} // namespace esm
