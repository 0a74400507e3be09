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

/// Positions, m, by their time's number, in intervals; 0 is the start. A motion's end that falls between two
/// has the number of the next.
using Trajectory = std::map<long, std::vector<Eigen::Vector3d>>;

/// Keeps those of a run's frames that are compared with another run's: that at the end, and those at
/// multiples of the recording interval, which runs in other steps meet as well. They are so few that memory
/// holds them, however long the run. Of two runs it keeps the same times.
class ComparedFrames {
public:
    /// Of a scene of so many seconds, recorded so often, s.
    ComparedFrames(double duration, double every);

    void add(double time, const std::vector<Eigen::Vector3d>& positions);

    /// By the number of the recording interval.
    const Trajectory& frames() const { return m_frames; }

private:
    void thinOut();

    double m_interval, m_duration; ///< s
    long m_met = 0, m_stride = 1;
    Trajectory m_frames;
};

/// Relative to the motion of `reference`, over the times both have; infinite when they share none but the
/// start, or nothing moves.
double relativeError(const Trajectory& trajectory, const Trajectory& reference);

/// The same of two runs of one scene, but 0 where they are alike to the last bit, as where nothing moves.
double changeBetween(const Trajectory& coarse, const Trajectory& finer);

/// Halving a step that leaves more than this of the change before gains nothing: rounding spoils it.
inline constexpr double leastGain = 0.9;

/// A larger change does not come of rounding, but of steps that do not follow the motion yet.
inline constexpr double unfollowedChange = 0.1;

/// What the latest halvings of a step changed, relative to the motion; infinite where there was none.
struct LatestChanges {
    static constexpr double none = std::numeric_limits<double>::infinity();

    double last = none, beforeLast = none, beforeThat = none;

    void add(double change) { *this = {change, last, beforeLast}; }
};

/// What is left of a trajectory's error, relative to its motion. If each halving leaves the same share r of
/// the error, then r·change/(1 − r) is left. Two shares can be told from the last three changes; the larger
/// one counts, since errors fall by fits and starts where motion has corners, as where springs stiffen. With
/// fewer changes a half is taken to be left at least. Orders above the second are believed to gain no more
/// than the second; those below the first no more than they promise.
///
/// A change that fell by more than the order promises is luck: two parts of the error cancelled, and one of
/// them will come to light. It counts as what the order would have left of the two changes before.
double remainingError(const LatestChanges& changes, double order);

/// How many halvings one after the other may gain nothing before no more is expected of them: where an
/// instrument touches or a node is led, what the next one gains is a matter of chance.
struct HalvingPatience {
    int followed = 3;
    int unfollowed = 7; ///< while steps do not follow the motion yet
};

/// What one halving of the step after another changes of a trajectory, relative to its motion.
class HalvingChanges {
public:
    explicit HalvingChanges(const HalvingPatience& patience = {}) : m_patience(patience) {}

    /// @param order to which power of the step errors fall
    void add(double change, double order);

    /// Whether the latest one made the change smaller.
    bool gained() const { return m_inVain == 0; }
    /// Of the latest trajectory's error. Of changes that stand still the largest is taken: trajectories that
    /// differ by chance are no further from the truth than from each other.
    double remaining() const;
    /// Whether the latest halvings gained nothing, and will not.
    bool standsStill() const {
        return m_inVain >= (m_largest < unfollowedChange ? m_patience.followed : m_patience.unfollowed);
    }

private:
    HalvingPatience m_patience;
    double m_order = 1;
    LatestChanges m_changes;
    double m_largest = 0; ///< since the latest that gained
    int m_inVain = 0;
};

} // namespace esm
