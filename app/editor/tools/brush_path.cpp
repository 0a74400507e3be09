#include "app/editor/tools/brush_path.h"

#include "core/support/angles.h"

#include <cmath>

namespace esm {

namespace {

/// The cosine of the sharpest turn that is still part of a bend.
constexpr double leastStraightness = 0.5;

struct Seen {
    double share; ///< of the way
    QPointF place;
    std::optional<BrushPoint> point;
};

/// Halves the way until two places show points that are close enough, or lie within a pixel: a mouse tells
/// few places of a fast stroke, and between two of them the surface may bend or end.
class WayFinder {
public:
    WayFinder(const Sight& sight, const MouseWay& way, double spacing)
        : m_sight(sight), m_way(way), m_spacing(spacing) {}

    std::vector<WayPoint> points() {
        m_points.clear();
        refine(at(0), at(1));
        return std::move(m_points);
    }

private:
    Seen at(double share) const {
        const QPointF place = m_way.at(share);
        return {share, place, brushPointAt(m_sight, place)};
    }

    void refine(const Seen& from, const Seen& to) {
        const bool areSeen = from.point && to.point;
        const double way = areSeen ? (from.point->place - to.point->place).norm() : 0;
        const bool areClose = areSeen && way <= m_spacing;
        if (!areClose && distance(from.place, to.place) > 1) {
            const Seen between = at((from.share + to.share) / 2);
            refine(from, between);
            return refine(between, to);
        }
        if (!areClose && isEdge(from, to, way)) m_points.push_back({std::nullopt, from.share});
        m_points.push_back({to.point, to.share});
    }

    /// Surface that is seen at a slant takes more than the spacing in a pixel too, though not much more.
    bool isEdge(const Seen& from, const Seen& to, double way) const {
        constexpr double mostOfOneSurface = 4; // spacings
        return from.point && to.point && way > mostOfOneSurface * m_spacing;
    }

    const Sight& m_sight;
    const MouseWay& m_way;
    double m_spacing;
    std::vector<WayPoint> m_points;
};

} // namespace

void MouseWay::goTo(const QPointF& place) {
    if (m_from != m_to) m_before = m_from;
    m_from = m_to;
    m_to = place;
}

QPointF MouseWay::at(double share) const {
    const QPointF ahead = m_to - m_from;
    const QPointF straight = m_from + share * ahead;
    if (!m_before || ahead.isNull()) return straight;
    const QPointF behind = m_from - *m_before;
    const double lengthAhead = distance(m_from, m_to), lengthBehind = distance(*m_before, m_from);
    if (QPointF::dotProduct(ahead, behind) < leastStraightness * lengthAhead * lengthBehind) return straight;
    // Passed with even speed, the parabola is at the place before so many pieces before this one begins.
    const double before = lengthBehind / lengthAhead;
    const QPointF bend = (ahead - behind / before) / (1 + before);
    // A piece of few pixels hardly has a direction, which bends no long one.
    return straight - std::min(1.0, before) * share * (1 - share) * bend;
}

std::optional<BrushPoint> brushPointAt(const Sight& sight, const QPointF& place) {
    const auto picked = sight.pickAt(place);
    if (!picked || picked->normal.isZero()) return std::nullopt;
    return BrushPoint{picked->spot.point, picked->normal};
}

std::vector<WayPoint> brushPointsAlong(const Sight& sight, const MouseWay& way, double spacing) {
    return WayFinder(sight, way, spacing).points();
}

bool isNearSurface(const Sight& sight, const QPointF& place) {
    constexpr int directions = 12;
    for (const double reach : {0.0, 4.0, 8.0, 12.0}) // pixels
        for (int i = 0; i < directions; ++i) {
            const double angle = 2 * pi * i / directions;
            if (sight.pickAt(place + reach * QPointF(std::cos(angle), std::sin(angle)))) return true;
        }
    return false;
}

} // namespace esm
