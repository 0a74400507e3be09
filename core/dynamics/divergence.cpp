#include "core/dynamics/divergence.h"

#include "core/dynamics/bursting.h"
#include "core/dynamics/forces.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace esm {

namespace {

constexpr double alwaysGood = 3;    ///< times the size or the reach
constexpr double energyMargin = 4;  ///< steps near their critical length let the energy swing
constexpr double fastestAnswer = 2; ///< times the speed of something heavy that hits it

bool allFinite(const Vectors& vectors) {
    return std::all_of(vectors.begin(), vectors.end(), [](const auto& v) { return v.allFinite(); });
}

Eigen::Vector3d middle(const Vectors& positions) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& position : positions)
        sum += position;
    return sum / static_cast<double>(positions.size());
}

/// Of the node farthest from the middle, m.
double spread(const Vectors& positions, const Eigen::Vector3d& centre) {
    double farthest = 0;
    for (const Eigen::Vector3d& position : positions)
        farthest = std::max(farthest, (position - centre).squaredNorm());
    return std::sqrt(farthest);
}

double workOfForces(const DivergenceGuard::Step& step) {
    double work = workOfPressures(step.system, step.loads, step.before, step.after);
    for (const auto& [node, force] : step.loads.forces)
        work += force.dot(step.after[node] - step.before[node]);
    if (!step.loads.gravity.isZero(0))
        for (std::size_t i = 0; i < step.after.size(); ++i)
            work += step.system.mass[i] * step.loads.gravity.dot(step.after[i] - step.before[i]);
    return work;
}

} // namespace

// Too long a step multiplies the fastest swing by more than 1 each time, until numbers overflow [R 2.2]. Size
// alone does not tell that from tissue that was pulled far or fell, and energy costs a pass over all springs.
// So size is asked first, which every step can afford; only tissue that has become much larger than it was
// and than its loads reach is asked where its energy came from. Growth by a factor in each step soon leaves
// any margin behind. The margins are therefore wide, lest sound runs be stopped.
void DivergenceGuard::restart(const Vectors& rest) {
    *this = {};
    m_size = rest.empty() ? 0 : spread(rest, middle(rest));
}

// The work of a led node or an instrument does not follow from its way alone, but it has a bound. What is
// light leaves with at most twice the speed of something heavy that hits it. All of the tissue is therefore
// taken to have got twice the speed of the fastest load there ever was.
void DivergenceGuard::take(const Step& step, const Eigen::Vector3d& centre, double size) {
    m_work += workOfForces(step);
    for (const PrescribedNode& led : step.loads.prescribed) {
        const double way = (led.position - step.before[led.node]).norm();
        m_reach = std::max(m_reach, (led.position - centre).norm());
        m_fastestLoad = std::max(m_fastestLoad, way / step.duration);
    }
    for (std::size_t i = 0; i < step.loads.instruments.size(); ++i) {
        const PlacedCollider& instrument = step.loads.instruments[i];
        const ColliderAxis axis = axisOf(instrument);
        const double radius = radiusOf(instrument.shape);
        const double distance = (axis.at(axis.nearest(centre)) - centre).norm();
        if (distance > size + radius) continue;
        m_reach = std::max(m_reach, distance + radius);
        if (i < step.instrumentWays.size())
            m_fastestLoad = std::max(m_fastestLoad, step.instrumentWays[i] / step.duration);
        else // It has no speed, but thrusts aside what is in its place.
            m_work = std::max(m_work, energy(step.system, step.after, step.velocities).total());
    }
}

std::string DivergenceGuard::problemOf(const Step& step) {
    if (step.after.empty()) return {};
    const Eigen::Vector3d centre = middle(step.after);
    const double size = spread(step.after, centre);
    if (!std::isfinite(size) || !allFinite(step.after) || !allFinite(step.velocities))
        return "the motion grew beyond all numbers";
    if (std::string burst = burstOf(step.system, step.after); !burst.empty()) return burst;
    DivergenceGuard next = *this;
    next.take(step, centre, size);
    if (m_size > 0 && size > alwaysGood * std::max(m_size, next.m_reach)) {
        const double mass = std::accumulate(step.system.mass.begin(), step.system.mass.end(), 0.0);
        const double pushed = 0.5 * mass * std::pow(fastestAnswer * next.m_fastestLoad, 2);
        const double given = std::max(0.0, next.m_work) + pushed;
        const double held = energy(step.system, step.after, step.velocities).total();
        if (!std::isfinite(held) || held > energyMargin * given)
            return "the tissue flew apart with more energy than anything gave it";
    }
    *this = next;
    return {};
}

} // namespace esm
