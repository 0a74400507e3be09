#pragma once

#include "core/texture/layers/brush_stroke.h"
#include "widgets/view/sight.h"

#include <optional>
#include <vector>

namespace esm {

/// The surface in the picture's place, seen from its outside; nothing beside it.
std::optional<BrushPoint> brushPointAt(const Sight& sight, const QPointF& place);

/// The way of the mouse between its last two places. It follows the parabola through the last three, since a
/// fast mouse tells few; a turn of more than 60° stays a corner.
class MouseWay {
public:
    /// Begins at a place (pixels).
    explicit MouseWay(const QPointF& place) : m_from(place), m_to(place) {}

    /// Goes on to the next place.
    void goTo(const QPointF& place);

    /// At a share of the way, 0 to 1.
    QPointF at(double share) const;

private:
    std::optional<QPointF> m_before;
    QPointF m_from, m_to;
};

/// A place on a way of the mouse.
struct WayPoint {
    std::optional<BrushPoint> point; ///< nothing where the way leaves the surface, or goes over an edge to
                                     ///< one that lies further behind
    double share;                    ///< of the way, 0 to 1
};

/// The surface under a way of the mouse, without the place where it begins: points at most `spacing`
/// (m) from one to the next where that is one surface.
std::vector<WayPoint> brushPointsAlong(const Sight& sight, const MouseWay& way, double spacing);

/// Whether surface is seen within a few pixels: who begins there to paint has just missed it.
bool isNearSurface(const Sight& sight, const QPointF& place);

} // namespace esm
