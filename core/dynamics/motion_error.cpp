#include "core/dynamics/motion_error.h"

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

} // namespace

void MotionError::add(const MotionPoints& points, const MotionPoints& reference, const MotionPoints& start) {
    for (std::size_t i = 0; i < points.size(); ++i) {
        m_difference += (points[i] - reference[i]).squaredNorm();
        m_motion += (reference[i] - start[i]).squaredNorm();
    }
}

double MotionError::relative() const {
    return m_motion > 0 ? std::sqrt(m_difference / m_motion) : std::numeric_limits<double>::infinity();
}

ComparedFrames::ComparedFrames(double duration, double every)
    : m_interval(std::clamp(every, duration / mostIntervals, duration)) {}

void ComparedFrames::add(double time, const MotionPoints& positions) {
    const double number = std::round(time / m_interval);
    if (std::abs(time - number * m_interval) > std::max(1e-6 * m_interval, 1e-12 * time)) return;
    if (m_met++ % m_stride != 0) return;
    if (m_frames.size() >= mostFramesOf(positions.size())) {
        m_stride *= 2;
        for (auto frame = m_frames.begin(); frame != m_frames.end(); ++frame)
            frame = std::prev(m_frames.erase(std::next(frame)));
    }
    m_frames.emplace(static_cast<long>(number), positions);
}

double relativeError(const Trajectory& trajectory, const Trajectory& reference) {
    MotionError error;
    for (const auto& [time, positions] : trajectory)
        if (const auto found = reference.find(time); found != reference.end())
            error.add(positions, found->second, reference.at(0));
    return error.relative();
}

double remainingError(double change, double lastChange) {
    // A ratio below that of the second order may be luck; one near 1 is that of rounding.
    constexpr double leastRatio = 0.25, mostRatio = leastGain;
    if (change == 0) return 0;
    const double ratio =
        std::isinf(lastChange) ? mostRatio : std::clamp(change / lastChange, leastRatio, mostRatio);
    return change * ratio / (1 - ratio);
}

void HalvingChanges::add(double change) {
    const bool gains = change <= leastGain * m_last;
    m_inVain = gains ? 0 : m_inVain + 1;
    m_largest = gains ? change : std::max(m_largest, change);
    m_beforeLast = m_last;
    m_last = change;
}

double HalvingChanges::remaining() const {
    return standsStill() ? m_largest : remainingError(m_last, m_beforeLast);
}

} // namespace esm
