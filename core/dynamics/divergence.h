#pragma once

#include "core/dynamics/energy.h"
#include "core/dynamics/loads.h"
#include "core/dynamics/spring_system.h"

#include <string>

namespace esm {

/// Tells a run that diverged from one whose loads drove the tissue far. Tissue no larger than a few times
/// what it is at rest, or than where it was led or pushed to, is always good. Beyond that its energy must
/// have come from the loads: from the work of forces, from the speed of what led and pushed it, or from an
/// instrument that appeared in its place.
class DivergenceGuard {
public:
    /// Starts anew from rest.
    void restart(const Vectors& rest);

    /// Takes note of a jump of the tissue's energy, J, as when its parameters change.
    void allow(double energy) { m_work += energy; }

    /// One step to judge.
    struct Step {
        const SpringSystem& system;
        const Vectors &before, &after; ///< positions, m
        const Vectors& velocities;     ///< after, m/s
        const Loads& loads;
        /// m, how far points of each instrument went during the step; those beyond its end have just
        /// appeared.
        const std::vector<double>& instrumentWays;
        double duration; ///< s
    };

    /// Why the step cannot be right; empty, and taken into account, when it can.
    std::string problemOf(const Step& step);

private:
    /// Takes a step's loads into account. `centre` is the tissue's middle after it, `size` how far it
    /// reaches.
    void take(const Step& step, const Eigen::Vector3d& centre, double size);

    double m_size = 0;        ///< m, of the tissue at rest
    double m_reach = 0;       ///< m, farthest from the tissue's middle that anything was led
    double m_work = 0;        ///< J, done by forces
    double m_fastestLoad = 0; ///< m/s, of what was led and of instruments
};

} // namespace esm
