#include "core/texture/atlas/reach.h"

#include <cmath>
#include <limits>
#include <utility>

namespace esm {

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

double rightReach(const Eigen::Vector2d& p, const Eigen::Vector2d& q, double y, double distance) {
    return -leftReach({-p.x(), p.y()}, {-q.x(), q.y()}, y, distance);
}

} // namespace esm
