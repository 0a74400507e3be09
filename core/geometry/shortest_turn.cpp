#include "core/geometry/shortest_turn.h"

#include <Eigen/Geometry>

#include <cmath>

namespace esm {

// The angle is taken from sine and cosine together: from the cosine alone, as the scalar product gives it,
// small turns would be lost in rounding. Eigen's own finds the axis of half a turn by a singular value
// decomposition, which takes longer to compile than all of its callers.
Eigen::Matrix3d shortestTurn(const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
    const Eigen::Vector3d across = from.cross(to);
    const Eigen::Vector3d axis = across.norm() > 0 ? across.normalized() : from.unitOrthogonal();
    return Eigen::AngleAxisd(std::atan2(across.norm(), from.dot(to)), axis).toRotationMatrix();
}

} // namespace esm
