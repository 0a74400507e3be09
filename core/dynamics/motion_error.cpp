#include "core/dynamics/motion_error.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace esm {

using MotionPoints = std::vector<Eigen::Vector3d>;

void MotionError::add(const MotionPoints& points, const MotionPoints& reference, const MotionPoints& start) {
    for (std::size_t i = 0; i < points.size(); ++i) {
        m_difference += (points[i] - reference[i]).squaredNorm();
        m_motion += (reference[i] - start[i]).squaredNorm();
    }
}

double MotionError::relative() const {
    return m_motion > 0 ? std::sqrt(m_difference / m_motion) : std::numeric_limits<double>::infinity();
}

double relativeError(const Trajectory& trajectory, const Trajectory& reference) {
    MotionError error;
    for (const auto& [time, positions] : trajectory)
        if (const auto found = reference.find(time); found != reference.end())
            error.add(positions, found->second, reference.at(0));
    return error.relative();
}

double remainingError(double change, double lastChange) {
    const double ratio = std::isinf(lastChange) ? 0.5 : std::min(0.5, change / lastChange);
    return change * ratio / (1 - ratio);
}

} // namespace esm
