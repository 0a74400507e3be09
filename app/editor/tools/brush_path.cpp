#include "app/editor/tools/brush_path.h"

#include "core/support/angles.h"

#include <cmath>

namespace esm {

namespace {

struct Seen {
    QPointF place;
    std::optional<BrushPoint> point;
};

/// Halves the way until two places show points that are close enough, or lie within a pixel: a mouse tells
/// few places of a fast stroke, and between two of them the surface may bend or end.
class WayFinder {
public:
    WayFinder(const Sight& sight, double spacing) : m_sight(sight), m_spacing(spacing) {}

    std::vector<WayPoint> along(const QPointF& from, const QPointF& to) {
        m_points.clear();
        m_from = from;
        m_length = distance(from, to);
        refine(at(from), at(to));
        return std::move(m_points);
    }

private:
    Seen at(const QPointF& place) const { return {place, brushPointAt(m_sight, place)}; }

    void refine(const Seen& from, const Seen& to) {
        const bool areSeen = from.point && to.point;
        const double way = areSeen ? (from.point->place - to.point->place).norm() : 0;
        const bool areClose = areSeen && way <= m_spacing;
        if (!areClose && distance(from.place, to.place) > 1) {
            const Seen between = at((from.place + to.place) / 2);
            refine(from, between);
            return refine(between, to);
        }
        if (!areClose && isEdge(from, to, way)) m_points.push_back({std::nullopt, shareAt(from.place)});
        m_points.push_back({to.point, shareAt(to.place)});
    }

    /// Surface that is seen at a slant takes more than the spacing in a pixel too, though not much more.
    bool isEdge(const Seen& from, const Seen& to, double way) const {
        constexpr double mostOfOneSurface = 4; // spacings
        return from.point && to.point && way > mostOfOneSurface * m_spacing;
    }

    double shareAt(const QPointF& place) const {
        return m_length > 0 ? distance(m_from, place) / m_length : 1;
    }

    const Sight& m_sight;
    double m_spacing;
    QPointF m_from;
    double m_length = 0; ///< pixels
    std::vector<WayPoint> m_points;
};

} // namespace

std::optional<BrushPoint> brushPointAt(const Sight& sight, const QPointF& place) {
    const auto picked = sight.pickAt(place);
    if (!picked || picked->normal.isZero()) return std::nullopt;
    return BrushPoint{picked->spot.point, picked->normal};
}

std::vector<WayPoint> brushPointsAlong(const Sight& sight, const QPointF& from, const QPointF& to,
                                       double spacing) {
    return WayFinder(sight, spacing).along(from, to);
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
