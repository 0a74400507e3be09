#include "core/dynamics/measure/motion_error.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace esm {

namespace {

using MotionPoints = std::vector<Eigen::Vector3d>;

constexpr std::size_t fewestCompared = 8, mostCompared = 100; ///< frames
constexpr std::size_t mostComparedPoints = 20'000'000;        ///< half a gigabyte
constexpr double mostIntervals = 1e12;                        ///< shorter ones cannot be told apart

/// Even, so that every other one can go.
std::size_t mostFramesOf(std::size_t points) {
    const std::size_t most = mostComparedPoints / std::max<std::size_t>(1, points);
    return std::clamp(most, fewestCompared, mostCompared) / 2 * 2;
}

/// Points that were not there at first move from where they were seen first.
void addNewcomers(MotionPoints& start, const MotionPoints& now) {
    for (std::size_t i = start.size(); i < now.size(); ++i)
        start.push_back(now[i]);
}

MotionError errorBetween(const Trajectory& trajectory, const Trajectory& reference) {
    MotionError error;
    MotionPoints start = reference.at(0);
    for (const auto& [time, positions] : trajectory) {
        const auto found = reference.find(time);
        if (found == reference.end()) continue;
        addNewcomers(start, found->second);
        error.add(positions, found->second, start);
    }
    return error;
}

} // namespace

void MotionError::add(const MotionPoints& points, const MotionPoints& reference, const MotionPoints& start) {
    const std::size_t inBoth = std::min(points.size(), reference.size());
    for (std::size_t i = 0; i < inBoth; ++i) {
        m_difference += (points[i] - reference[i]).squaredNorm();
        m_motion += (reference[i] - start[i]).squaredNorm();
    }
}

double MotionError::relative() const {
    return m_motion > 0 ? std::sqrt(m_difference / m_motion) : std::numeric_limits<double>::infinity();
}

ComparedFrames::ComparedFrames(double duration, double every)
    : m_interval(std::clamp(every, duration / mostIntervals, duration)), m_duration(duration) {}

void ComparedFrames::add(double time, const MotionPoints& positions) {
    const double intervals = time / m_interval, number = std::round(intervals);
    const bool isMultiple = std::abs(intervals - number) <= std::max(1e-6, 1e-12 * number);
    if (time >= m_duration) {
        m_frames.insert_or_assign(static_cast<long>(isMultiple ? number : std::ceil(intervals)), positions);
    } else if (isMultiple && m_met++ % m_stride == 0) {
        if (m_frames.size() >= mostFramesOf(positions.size())) thinOut();
        m_frames.emplace(static_cast<long>(number), positions);
    }
}

/// Every other one goes, but the start.
void ComparedFrames::thinOut() {
    m_stride *= 2;
    for (auto frame = m_frames.begin(); frame != m_frames.end() && ++frame != m_frames.end();)
        frame = m_frames.erase(frame);
}

double relativeError(const Trajectory& trajectory, const Trajectory& reference) {
    return errorBetween(trajectory, reference).relative();
}

double changeBetween(const Trajectory& coarse, const Trajectory& finer) {
    const MotionError change = errorBetween(coarse, finer);
    return change.isNone() ? 0 : change.relative();
}

// Richardson's extrapolation (1911), made careful. If errors fall by the share r with each halving, the
// changes still to come are change·(r + r² + …) = change·r/(1 − r). An integrator of the order p promises r =
// 2⁻ᵖ. Scenes do not always keep that promise, so that r is also taken from the changes themselves, and the
// larger one counts; less than ¼, that of the second order, is not believed. Before there are changes to
// compare, r is taken as badly as it may be.
double remainingError(const LatestChanges& changes, double order) {
    constexpr double mostShare = leastGain; // above, it is rounding that spoils the gain
    constexpr double unsureShare = 0.5;
    const auto& [last, beforeLast, beforeThat] = changes;
    if (last == 0) return 0;
    if (std::isinf(beforeLast)) return last * mostShare / (1 - mostShare);
    const double promised = std::exp2(-order);
    double believed = std::max(last, promised * beforeLast);
    double share = std::max(last / beforeLast, std::max(promised, 0.25));
    if (std::isinf(beforeThat)) {
        share = std::max(share, unsureShare);
    } else {
        believed = std::max(believed, promised * promised * beforeThat);
        share = std::max(share, beforeLast / beforeThat);
    }
    share = std::min(share, mostShare);
    return believed * share / (1 - share);
}

void HalvingChanges::add(double change, double order) {
    m_order = order;
    const bool gains = change <= leastGain * m_changes.last;
    m_inVain = gains ? 0 : m_inVain + 1;
    m_largest = gains ? change : std::max(m_largest, change);
    m_changes.add(change);
}

// Changes that do not fall any more, and are small, are no series with a limit: contacts that come a step
// sooner or later throw the motion to one side or the other. To extrapolate would multiply that chance by
// r/(1 − r), up to nine; the largest change there was says as much as is known.
double HalvingChanges::remaining() const {
    const bool isByChance = m_inVain >= HalvingPatience().followed && m_largest < unfollowedChange;
    return isByChance ? m_largest : remainingError(m_changes, m_order);
}

} // namespace esm
