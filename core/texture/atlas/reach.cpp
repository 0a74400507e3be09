#include "core/texture/atlas/reach.h"

#include <cmath>
#include <limits>
#include <utility>

namespace esm {

/// What lies near a segment is a stadium: a strip with a half disc at either end. Its left border is the
/// segment, moved out by the distance along its normal, between the heights of its two ends, and a circle
/// beyond them. The strip is asked first; where the line passes above or below it, the circle of the end on
/// that side is met. A segment that lies along the line has no strip to the left, only the circle of its left
/// end.
double leftReach(Eigen::Vector2d p, Eigen::Vector2d q, double y, double distance) {
    if (p.y() > q.y() || (p.y() == q.y() && p.x() > q.x())) std::swap(p, q);
    const Eigen::Vector2d along = q - p;
    if (along.y() > 0) {
        const Eigen::Vector2d offset = distance / along.norm() * Eigen::Vector2d(-along.y(), along.x());
        const double fraction = (y - p.y() - offset.y()) / along.y();
        if (fraction >= 0 && fraction <= 1) return p.x() + offset.x() + fraction * along.x();
        if (fraction > 1) p = q;
    }
    const double square = distance * distance - (y - p.y()) * (y - p.y());
    return square > 0 ? p.x() - std::sqrt(square) : std::numeric_limits<double>::infinity();
}

/// The mirror image.
double rightReach(const Eigen::Vector2d& p, const Eigen::Vector2d& q, double y, double distance) {
    return -leftReach({-p.x(), p.y()}, {-q.x(), q.y()}, y, distance);
}

} // namespace esm
