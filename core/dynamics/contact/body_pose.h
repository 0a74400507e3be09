#pragma once

#include "core/dynamics/contact/touched_surface.h"
#include "core/dynamics/spring_system.h"

namespace esm {

/// Where a body is that moves with the line between two nodes: about the line's middle, turned as the line
/// is.
class BodyPose {
public:
    BodyPose(const TouchedSurface::Body& body, const Vectors& positions);

    /// Of a point of the body at rest, m, and back.
    Eigen::Vector3d now(const Eigen::Vector3d& atRest) const;
    Eigen::Vector3d atRest(const Eigen::Vector3d& now) const;

private:
    Eigen::Matrix3d m_turn;
    Eigen::Vector3d m_middleAtRest, m_middle;
};

} // namespace esm
