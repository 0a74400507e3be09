#include "core/dynamics/measure/timeline.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

namespace esm {

namespace {

/// s, times that differ by no more are the same: a billionth of a step, or what rounding makes of the
/// longest.
double closeTimes(double timeStep, double duration) {
    return std::max(1e-9 * timeStep, 4 * std::numeric_limits<double>::epsilon() * duration);
}

/// Lengths of cut steps that an integrator may factorise for in one run. Each costs a factorisation, and the
/// memory of its factor.
constexpr std::size_t mostLengths = 8;
/// With more nodes a factorisation costs more than it gains, in time and in memory.
constexpr std::size_t mostNodesForLengths = 100'000;

/// Those that factorise no matrix: a step of another length costs them nothing.
bool cutsEverywhere(Integrator integrator) {
    return isExplicit(integrator) || traitsOf(integrator).kind == StepKind::Searching;
}

void addCorner(std::set<double>& corners, double time, double duration) {
    if (time > 0 && time < duration) corners.insert(time);
}

Eigen::Vector3d velocityBetween(const PathPoint& from, const PathPoint& to) {
    return (to.value - from.value) / (to.time - from.time);
}

/// Not those that rounding leaves between points on one line.
bool isTurn(const Eigen::Vector3d& before, const Eigen::Vector3d& after) {
    constexpr double rounding = 1e-9;
    return (after - before).norm() > rounding * std::max(before.norm(), after.norm());
}

/// Pa/s, along x.
Eigen::Vector3d velocityBetween(const PressurePoint& from, const PressurePoint& to) {
    return {(to.pressure - from.pressure) / (to.time - from.time), 0, 0};
}

/// Where the velocity changes along the path, which stands still before its first point and after its last.
template<class Point>
void addCorners(std::set<double>& corners, const std::vector<Point>& path, double duration) {
    Eigen::Vector3d before = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < path.size(); ++i) {
        Eigen::Vector3d after = Eigen::Vector3d::Zero();
        if (i + 1 < path.size()) after = velocityBetween(path[i], path[i + 1]);
        if (isTurn(before, after)) addCorner(corners, path[i].time, duration);
        before = after;
    }
}

/// rad/s, evenly from one orientation to the next, the shorter way round.
Eigen::Vector3d turningBetween(const InstrumentMotion& instrument, std::size_t from) {
    const Eigen::AngleAxisd turn(instrument.orientations[from + 1] *
                                 instrument.orientations[from].conjugate());
    return turn.angle() / (instrument.path[from + 1].time - instrument.path[from].time) * turn.axis();
}

/// Where the speed of its turning changes.
void addTurningCorners(std::set<double>& corners, const InstrumentMotion& instrument, double duration) {
    Eigen::Vector3d before = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < instrument.orientations.size(); ++i) {
        const bool isLast = i + 1 == instrument.orientations.size();
        const Eigen::Vector3d after =
            isLast ? Eigen::Vector3d(Eigen::Vector3d::Zero()) : turningBetween(instrument, i);
        if (isTurn(before, after)) addCorner(corners, instrument.path[i].time, duration);
        before = after;
    }
}

/// Without those that are the same time as the start, the one before or the end: scripts add up 0.1 and 0.2
/// to a little more than 0.3.
std::set<double> apart(const std::set<double>& corners, double close, double duration) {
    std::set<double> kept;
    for (const double corner : corners)
        if (corner > (kept.empty() ? 0 : *kept.rbegin()) + close && corner < duration - close)
            kept.insert(kept.end(), corner);
    return kept;
}

/// Chooses the whole steps that are cut at the corners in them, as long as that takes few lengths. Two cuts
/// of the same length need one matrix, and loads often begin and end at round times: so lengths are counted,
/// and not cuts. Greedy, in the order in which corners are offered: which choice would cut most is not worth
/// searching for.
class CutChoice {
public:
    struct Times {
        double step, duration, close; ///< s
    };
    CutChoice(const Times& times, std::size_t mostLengths) : m_times(times), m_mostLengths(mostLengths) {}

    /// The steps that hold one of `wanted`, one after the other. @param all every corner: a step is cut at
    /// each that it holds, or at none
    void choose(const std::vector<double>& wanted, const std::set<double>& all) {
        for (const double corner : wanted) {
            const double step = std::floor((corner + m_times.close) / m_times.step);
            if (m_tried.insert(step).second) tryStep(step * m_times.step, all);
        }
    }
    std::vector<double> takeCorners() { return {m_corners.begin(), m_corners.end()}; }

private:
    void tryStep(double begin, const std::set<double>& all) {
        const double end = std::min(begin + m_times.step, m_times.duration);
        const std::vector<double> inside(all.lower_bound(begin - m_times.close),
                                         all.lower_bound(end - m_times.close));
        std::set<long> lengths = m_lengths;
        double last = begin;
        for (const double corner : inside)
            if (corner > begin + m_times.close) lengths.insert(lengthOf(std::exchange(last, corner), corner));
        if (last > begin) lengths.insert(lengthOf(last, end));
        if (lengths.size() > m_mostLengths) return;
        m_lengths = std::move(lengths);
        m_corners.insert(inside.begin(), inside.end());
    }
    long lengthOf(double from, double to) const { return std::lround((to - from) / m_times.close); }

    Times m_times;
    std::size_t m_mostLengths;
    std::set<double> m_corners, m_tried;
    std::set<long> m_lengths; ///< of cut steps, in times that are the same
};

} // namespace

std::vector<double> splitCorners(const Scene& scene) {
    std::set<double> corners;
    for (const SurfaceSplit& split : scene.splits)
        addCorner(corners, split.time, scene.duration);
    return {corners.begin(), corners.end()};
}

// A force that acts for no time gives no momentum.
std::vector<double> forceCorners(const Scene& scene) {
    std::set<double> corners;
    for (const NodeForce& force : scene.forces) {
        if (force.from == force.to) continue;
        addCorner(corners, force.from, scene.duration);
        addCorner(corners, force.to, scene.duration);
    }
    return {corners.begin(), corners.end()};
}

std::vector<double> pathCorners(const Scene& scene) {
    std::set<double> corners;
    for (const NodeMove& move : scene.moves)
        addCorners(corners, move.path, scene.duration);
    for (const PartPressure& pressure : scene.pressures)
        addCorners(corners, pressure.path, scene.duration);
    for (const InstrumentMotion& instrument : scene.instruments) {
        addCorners(corners, instrument.path, scene.duration);
        addTurningCorners(corners, instrument, scene.duration);
    }
    return {corners.begin(), corners.end()};
}

// Splits come first, then forces, then paths, so that what finds no length left matters least. Inside a step
// that is not cut a path still leads to its place at the step's end, and a force counts with its mean; but a
// split comes late.
Timeline::Timeline(const Scene& scene, const TimeDivision& division, Integrator integrator,
                   std::size_t nodeCount)
    : m_nominal(division.timeStep), m_step(division.stepLength()), m_duration(scene.duration),
      m_parts(std::ldexp(1, division.halvings)), m_close(closeTimes(m_nominal, scene.duration)) {
    const std::vector<double> ofSplits = splitCorners(scene), ofForces = forceCorners(scene),
                              ofPaths = pathCorners(scene);
    std::set<double> all(ofForces.begin(), ofForces.end());
    all.insert(ofPaths.begin(), ofPaths.end());
    all.insert(ofSplits.begin(), ofSplits.end());
    all = apart(all, m_close, m_duration);
    if (cutsEverywhere(integrator)) {
        m_corners.assign(all.begin(), all.end());
    } else {
        CutChoice choice({m_nominal, m_duration, m_close},
                         nodeCount <= mostNodesForLengths ? mostLengths : 0);
        choice.choose(ofSplits, all);
        choice.choose(ofForces, all);
        choice.choose(ofPaths, all);
        m_corners = choice.takeCorners();
        m_averaged = all.size() - m_corners.size();
    }
    m_corners.push_back(m_duration);
    m_all.assign(all.begin(), all.end());
    enter();
}

/// Finds what lies ahead where a nominal step, or a part of a cut one, begins.
void Timeline::enter() {
    while (m_next < m_corners.size() && m_corners[m_next] <= m_time)
        ++m_next;
    if (isAtEnd()) return;
    const double corner = m_corners[m_next];
    const double begin = wholeTime(m_taken), end = wholeTime(m_taken + m_parts);
    const bool isAtBegin = std::abs(m_time - begin) <= m_close;
    m_whole = isAtBegin ? m_parts * std::floor((corner - begin + m_close) / m_nominal) : 0;
    m_piece.reset();
    if (m_whole == 0) m_piece = pieceUntil(corner < end + m_close ? corner : end);
}

/// However often steps are halved, none becomes so short that its ends are the same time.
Timeline::Piece Timeline::pieceUntil(double end) const {
    const double most = std::floor((end - m_time) / m_close);
    return {m_time, end, std::clamp(most, 1.0, m_parts)};
}

TimeSpan Timeline::next(double until, std::size_t most) const {
    if (m_piece) {
        const auto& [begin, end, parts, step] = *m_piece;
        const bool isLast = step + 1 >= parts;
        const double reached = isLast ? end : begin + (step + 1) / parts * (end - begin);
        return {m_time, reached, 1, false, meetsCorner(reached)};
    }
    const double wanted = std::clamp(std::ceil((until - m_time - m_close) / m_step), 1.0,
                                     std::max(1.0, static_cast<double>(most)));
    const double steps = std::min(m_whole, wanted);
    const double corner = m_corners[m_next], end = wholeTime(m_taken + steps);
    const double reached = end > corner - m_close ? corner : end;
    return {m_time, reached, static_cast<std::size_t>(steps), true, meetsCorner(reached)};
}

// Corners closer together than steps are those of a smooth path, as it was recorded: what steps can follow of
// it they follow best by building on each other.
bool Timeline::meetsCorner(double end) const {
    const double apart = 2 * m_step - m_close;
    const auto isApart = [&](auto corner) {
        return (corner == m_all.begin() || *corner - *(corner - 1) > apart) &&
               (corner + 1 == m_all.end() || *(corner + 1) - *corner > apart);
    };
    auto corner = std::upper_bound(m_all.begin(), m_all.end(), m_time - m_last + m_close);
    for (; corner != m_all.end() && *corner < end - m_close; ++corner)
        if (isApart(corner)) return true;
    return false;
}

void Timeline::advance(const TimeSpan& span, std::size_t steps) {
    if (steps == 0) return;
    const auto taken = static_cast<double>(steps);
    m_last = (span.end - span.start) / static_cast<double>(span.steps);
    m_time = steps == span.steps ? span.end : wholeTime(m_taken + taken);
    if (m_piece) {
        m_piece->step += 1;
        if (m_piece->step < m_piece->parts) return;
        if (m_time > wholeTime(m_taken + m_parts) - m_close) m_taken += m_parts;
        enter();
    } else {
        m_taken += taken;
        m_whole -= taken;
        if (m_whole == 0) enter();
    }
}

} // namespace esm
