#include "core/dynamics/contact/body_pose.h"

#include "core/geometry/shortest_turn.h"

namespace esm {

// Two nodes tell a place and a direction. How the body is turned about their line they do not tell: the
// shortest turn adds none.
BodyPose::BodyPose(const TouchedSurface::Body& body, const Vectors& positions)
    : m_turn(Eigen::Matrix3d::Identity()), m_middleAtRest((body.first + body.second) / 2),
      m_middle((positions[body.line.first] + positions[body.line.second]) / 2) {
    const Eigen::Vector3d rest = body.second - body.first,
                          line = positions[body.line.second] - positions[body.line.first];
    if (rest.norm() > 0 && line.norm() > 0) m_turn = shortestTurn(rest, line);
}

Eigen::Vector3d BodyPose::now(const Eigen::Vector3d& atRest) const {
    return m_middle + m_turn * (atRest - m_middleAtRest);
}

Eigen::Vector3d BodyPose::atRest(const Eigen::Vector3d& now) const {
    return m_middleAtRest + m_turn.transpose() * (now - m_middle);
}

} // namespace esm
