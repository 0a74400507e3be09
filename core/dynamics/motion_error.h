#pragma once

#include <Eigen/Core>

#include <limits>
#include <map>
#include <vector>

namespace esm {

/// Sums up how far one motion is from another: √(Σ|x − x_ref|² / Σ|x_ref − x_0|²).
class MotionError {
public:
    /// The same points at one time, and where they started from, m.
    void add(const std::vector<Eigen::Vector3d>& points, const std::vector<Eigen::Vector3d>& reference,
             const std::vector<Eigen::Vector3d>& start);

    /// Relative to the reference's motion itself; infinite without any motion.
    double relative() const;
    /// To the last bit the same.
    bool isNone() const { return m_difference == 0; }

private:
    double m_difference = 0, m_motion = 0; ///< m², sums
};

/// Positions, m, by their time's number, in intervals; 0 is the start.
using Trajectory = std::map<long, std::vector<Eigen::Vector3d>>;

/// Keeps of a run's frames those that are compared with another run's: at times that are multiples of the
/// recording interval, so that runs in other steps meet them, and so few that memory holds them, however long
/// the run. Of two runs it keeps the same times.
class ComparedFrames {
public:
    /// Of a scene of so many seconds, recorded so often, s.
    ComparedFrames(double duration, double every);

    void add(double time, const std::vector<Eigen::Vector3d>& positions);

    /// By the number of the recording interval.
    const Trajectory& frames() const { return m_frames; }

private:
    double m_interval; ///< s
    long m_met = 0, m_stride = 1;
    Trajectory m_frames;
};

/// Relative to the motion of `reference`, over the times both have; infinite when they share none but the
/// start, or nothing moves.
double relativeError(const Trajectory& trajectory, const Trajectory& reference);

/// Of what was there before, halving a step leaves at most that, or it gains nothing: rounding spoils it.
inline constexpr double leastGain = 0.9;

/// A larger change of halving a step comes of steps that do not follow the motion yet, not of rounding.
inline constexpr double unfollowedChange = 0.1;

/// What is left of a trajectory's error, relative to its motion, from how much halving the step changed it
/// and how much the halving before did (infinite: there was none). How much of what is left each halving
/// takes away, two of them tell; one alone may have taken little.
double remainingError(double change, double lastChange);

/// What one halving of the step after another changes of a trajectory, relative to its motion.
class HalvingChanges {
public:
    void add(double change);

    /// Of the latest trajectory's error. Of changes that stand still the largest is taken: trajectories that
    /// differ by chance, as where an instrument touches, are no further from the truth than from each other.
    double remaining() const;
    /// Whether the latest halvings gained nothing, and will not.
    bool standsStill() const { return m_inVain >= mostInVain && m_largest < unfollowedChange; }

private:
    static constexpr int mostInVain = 2;

    double m_last = std::numeric_limits<double>::infinity(), m_beforeLast = m_last;
    double m_largest = 0; ///< since the latest that gained
    int m_inVain = 0;
};

} // namespace esm
