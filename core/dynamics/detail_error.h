#pragma once

#include "core/dynamics/settings.h"
#include "core/model/project.h"
#include "core/support/progress.h"

namespace esm {

/// Sums up how far one motion is from another: √(Σ|x − x_ref|² / Σ|x_ref − x_0|²).
class MotionError {
public:
    /// The same points at one time, and where they started from, m.
    void add(const std::vector<Eigen::Vector3d>& points, const std::vector<Eigen::Vector3d>& reference,
             const std::vector<Eigen::Vector3d>& start);

    /// Relative to the reference's motion itself; infinite without any motion.
    double relative() const;

private:
    double m_difference = 0, m_motion = 0; ///< m², sums
};

/// What a level of detail costs in accuracy: runs the project's own scene as it is and at that level, in the
/// same steps, and compares where the nodes carry the drawn vertices at the recorded times.
/// @throws InvalidModel when the surface has no such level, or one of the runs does not end as it should;
/// Cancelled
double detailError(const Project& project, const Detail& detail, const SimulationSettings& settings = {},
                   const Progress& progress = {});

} // namespace esm
