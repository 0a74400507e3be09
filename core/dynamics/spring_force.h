#pragma once

#include "core/dynamics/matrix_factors.h"
#include "core/dynamics/settings.h"
#include "core/dynamics/spring_system.h"

#include <Eigen/Core>

/// What one spring does, seen from one of its ends: `between` points there from the other end, m, and
/// `approach` is the same difference of velocities, m/s. The other end gets the opposite.
namespace esm {

/// N. Force is tension over length times the vector between the ends, so that no direction has to be divided
/// out first. A spring of zero length has no direction and gives none.
inline Eigen::Vector3d elasticForce(const SpringSystem::Element& spring, const Eigen::Vector3d& between) {
    const double length = between.norm();
    if (!(length > 0)) return Eigen::Vector3d::Zero();
    return -between * tensionPerLength(spring.springConstant, spring.secondPhase, spring.restLength / length);
}

/// N. Of a spring without length the normalised direction is zero, and so is its axial damping: it has no
/// axis.
inline Eigen::Vector3d dampingForce(const SpringSystem::Element& spring, Damping damping,
                                    const Eigen::Vector3d& between, const Eigen::Vector3d& approach) {
    if (damping == Damping::Isotropic) return -spring.viscosity * approach;
    const Eigen::Vector3d direction = between.normalized();
    return -spring.viscosity * (direction * direction.dot(approach));
}

/// How the elastic force changes with its ends' places, N/m. With tension T(l) along the direction n:
/// lengthened, it changes by dT/dl along n; turned, it keeps its size and turns with n, which is T/l across.
/// T/l is below zero for a pressed spring: it pushes its ends further aside the further they are aside.
struct SpringTangent {
    Eigen::Vector3d direction = Eigen::Vector3d::Zero();
    double axial = 0, lateral = 0;
};

inline SpringTangent tangentOf(const SpringSystem::Element& spring, const Eigen::Vector3d& between) {
    const double length = between.norm();
    if (!(length > 0)) return {};
    const double restRatio = spring.restLength / length;
    return {between / length, slope(spring.springConstant, spring.secondPhase, restRatio),
            tensionPerLength(spring.springConstant, spring.secondPhase, restRatio)};
}

/// (dampingFactor·D + stiffnessFactor·K) of one spring, times a difference between its ends.
inline Eigen::Vector3d resistance(const SpringSystem::Element& spring, const SpringTangent& tangent,
                                  Damping damping, const MatrixFactors& factors,
                                  const Eigen::Vector3d& difference) {
    const auto& [direction, axial, lateral] = tangent;
    const double viscous = factors.damping * spring.viscosity;
    const double across = factors.stiffness * lateral + (damping == Damping::Axial ? 0 : viscous);
    const double along = factors.stiffness * axial + viscous;
    return across * difference + (along - across) * direction.dot(difference) * direction;
}

} // namespace esm
