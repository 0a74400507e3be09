#include "core/texture/layers/healing.h"

#include "core/support/angles.h"

#include <algorithm>
#include <cmath>

namespace esm {

namespace {

constexpr double discSpacing = 0.2;    ///< shares of the radius from one disc to the next
constexpr std::size_t mostDiscs = 400; ///< beyond, they lie farther apart
constexpr int directions = 24;         ///< around a disc
constexpr double beside = 1.04;        ///< shares of the radius, from the path to the places around
constexpr double leastBeside = 1.02;   ///< of those that count: less lies along the path, or under it

double lengthOf(const std::vector<BrushPoint>& path) {
    double length = 0;
    for (std::size_t i = 1; i < path.size(); ++i)
        length += (path[i].place - path[i - 1].place).norm();
    return length;
}

BrushPoint pointBetween(const BrushPoint& start, const BrushPoint& end, double t) {
    const Eigen::Vector3d normal = (1 - t) * start.normal.normalized() + t * end.normal.normalized();
    return {start.place + t * (end.place - start.place),
            normal.norm() > 0.1 ? normal.normalized() : start.normal.normalized()};
}

} // namespace

/// Evenly along the path, whatever lines it is made of: a fast hand makes few long ones, a slow one many. How
/// many there are is bounded, since each place around is compared with all of them.
StrokeOutline::StrokeOutline(const BrushStroke& stroke)
    : m_spacing(
          std::max(discSpacing * stroke.radius, lengthOf(stroke.path) / static_cast<double>(mostDiscs))) {
    const auto add = [&](std::size_t line, double t) {
        const std::size_t next = std::min(line + 1, stroke.path.size() - 1);
        const BrushShares shares = sharesBetween(stroke, line, t);
        m_discs.push_back(
            {pointBetween(stroke.path[line], stroke.path[next], t), shares.radius * stroke.radius});
    };
    add(0, 0);
    double walked = 0; // since the last disc
    for (std::size_t line = 0; line + 1 < stroke.path.size(); ++line) {
        const double length = (stroke.path[line + 1].place - stroke.path[line].place).norm();
        const double first = m_spacing - walked;
        const auto discs = static_cast<std::size_t>(std::max(0.0, 1 + (length - first) / m_spacing));
        for (std::size_t disc = 0; disc < discs; ++disc)
            add(line, std::min(1.0, (first + static_cast<double>(disc) * m_spacing) / length));
        walked = std::fmod(walked + length, m_spacing);
    }
    if (stroke.path.size() > 1) add(stroke.path.size() - 2, 1);
}

bool StrokeOutline::isBeyond(const Eigen::Vector3d& place, double share) const {
    for (std::size_t i = 0; i < m_discs.size(); ++i) {
        const Disc &start = m_discs[i], &end = m_discs[std::min(i + 1, m_discs.size() - 1)];
        const Eigen::Vector3d along = end.point.place - start.point.place, way = place - start.point.place;
        const double squared = along.squaredNorm();
        const double t = squared > 0 ? std::clamp(way.dot(along) / squared, 0.0, 1.0) : 0;
        const double radius = start.radius + t * (end.radius - start.radius);
        if ((way - t * along).norm() < share * radius) return false;
    }
    return true;
}

/// A ring around every disc, of which only what lies beside the whole stroke is left: its two sides, round
/// ends, and whatever shape a path has that turns and crosses itself.
std::vector<BrushPoint> StrokeOutline::placesAround() const {
    std::vector<BrushPoint> places;
    for (const auto& [point, radius] : m_discs) {
        if (!(radius > 0)) continue;
        const Eigen::Vector3d across = point.normal.unitOrthogonal(), along = point.normal.cross(across);
        for (int i = 0; i < directions; ++i) {
            const double angle = 2 * pi * i / directions;
            const Eigen::Vector3d place =
                point.place + beside * radius * (std::cos(angle) * across + std::sin(angle) * along);
            if (isBeyond(place, leastBeside)) places.push_back({place, point.normal});
        }
    }
    return places;
}

HealingRim::HealingRim(const std::vector<Place>& places, double spacing)
    : m_places(3, places.size()), m_differences(3, places.size()), m_blur(0.25 * spacing * spacing) {
    for (std::size_t i = 0; i < places.size(); ++i) {
        m_places.col(static_cast<Eigen::Index>(i)) = places[i].at;
        m_differences.col(static_cast<Eigen::Index>(i)) = places[i].difference;
    }
}

/// The membrane of Poisson editing (Pérez, Gangnet and Blake 2003): of all that has the given values around a
/// region the smoothest within, which solves Laplace's equation. Solved on a mesh, its triangles would have
/// to be finer than the stroke. Within a circle the solution is known in closed form, Poisson's integral
/// formula: the mean of what lies around, weighted by the inverse square of the distance. This mean is taken
/// whatever the stroke's outline, in the manner of Farbman et al. 2009, who replace the membrane by
/// barycentric coordinates of the outline: it is smooth within, meets what is given around, and is asked at
/// each texel by itself. Half a spacing is added to distances, else single places would show as spots.
Eigen::Vector3f HealingRim::at(const Eigen::Vector3d& point) const {
    if (m_places.cols() == 0) return Eigen::Vector3f::Zero();
    const Eigen::ArrayXd squared = (m_places.colwise() - point).colwise().squaredNorm().transpose();
    const Eigen::VectorXf weights = (1 / (squared + m_blur)).matrix().cast<float>();
    return m_differences * weights / weights.sum();
}

} // namespace esm
