#pragma once

#include "core/dynamics/spring_system.h"

#include <Eigen/Geometry>

#include <array>
#include <cmath>

/// What one hinge does to its four nodes.
///
/// It is a spring between two bars, the shared edge u and the line v between the other corners (HingeShape).
/// With s = Σ w·x the vector between fixed places of them, and N = u × v, its strain is r = s − γ·N and its
/// energy ½·κ·|r|², where γ is the rest curvature. Both s and N turn with the hinge, N tells up from down,
/// and moved as a whole a hinge does not change: momentum and angular momentum are kept. Stretched, the bars
/// come apart as those of a sheet that keeps its curvature.
///
/// At flat rest γ = 0, and the energy is the quadratic one of Bergou et al. (2006): linear forces and a
/// constant matrix κ·w·wᵀ, the same for x, y and z. The signed term in N does for curved rest what their
/// cubic one does (Garg et al. 2007), without their condition that nothing stretches. Angles of the triangles
/// (Grinspun et al. 2003) would do as well, but their forces have no bound where a triangle loses its height,
/// and no step would be sure to be stable. Here no length is divided by.
namespace esm {

using HingeVectors = std::array<Eigen::Vector3d, 4>; ///< one per node of the hinge, in its order

inline HingeVectors ofNodes(const SpringSystem::HingeElement& hinge, const Vectors& perNode) {
    const auto& [first, second, third, fourth] = hinge.nodes;
    return {perNode[first], perNode[second], perNode[third], perNode[fourth]};
}

/// Adds to the four nodes' vectors of all nodes. @param sign 1 or −1
inline void addToNodes(const SpringSystem::HingeElement& hinge, const HingeVectors& ofHinge, Vectors& perNode,
                       double sign = 1) {
    for (std::size_t i = 0; i < 4; ++i)
        perNode[hinge.nodes[i]] += sign * ofHinge[i];
}

/// Σ w·x, of differences, which are exact where the nodes are far from the origin.
inline Eigen::Vector3d betweenBars(const SpringSystem::HingeElement& hinge, const HingeVectors& at) {
    return hinge.weights[1] * (at[1] - at[0]) + hinge.weights[2] * (at[2] - at[0]) +
           hinge.weights[3] * (at[3] - at[0]);
}

/// A vector s*, dual to that between the bars, and two dual to the bars, as forces on the nodes. What is
/// added to one node is taken from others.
inline HingeVectors spreadOverNodes(const SpringSystem::HingeElement& hinge, const Eigen::Vector3d& between,
                                    const Eigen::Vector3d& edge, const Eigen::Vector3d& across) {
    const Eigen::Vector3d second = hinge.weights[1] * between + edge;
    const Eigen::Vector3d third = hinge.weights[2] * between - across;
    const Eigen::Vector3d fourth = hinge.weights[3] * between + across;
    return {-(second + third + fourth), second, third, fourth};
}

/// How a hinge lies: its bars, m, and its strain, m.
struct BentHinge {
    Eigen::Vector3d edge, across, strain;
};

inline BentHinge bentHinge(const SpringSystem::HingeElement& hinge, const HingeVectors& at) {
    const Eigen::Vector3d edge = at[1] - at[0], across = at[3] - at[2];
    return {edge, across, betweenBars(hinge, at) - hinge.restCurvature * edge.cross(across)};
}

/// J
inline double elasticEnergy(const SpringSystem::HingeElement& hinge, const HingeVectors& at) {
    return 0.5 * hinge.springConstant * bentHinge(hinge, at).strain.squaredNorm();
}

/// N: less the gradient of the energy, ∂N(δ) = δu × v + u × δv.
inline HingeVectors elasticForces(const SpringSystem::HingeElement& hinge, const HingeVectors& at) {
    const auto [edge, across, strain] = bentHinge(hinge, at);
    const Eigen::Vector3d force = -hinge.springConstant * strain, turning = hinge.restCurvature * force;
    return spreadOverNodes(hinge, force, -across.cross(turning), -turning.cross(edge));
}

/// N, −d·w·ṡ: as springs damp isotropically, whichever way these are told to damp.
inline HingeVectors dampingForces(const SpringSystem::HingeElement& hinge, const HingeVectors& velocities) {
    return spreadOverNodes(hinge, -hinge.viscosity * betweenBars(hinge, velocities), Eigen::Vector3d::Zero(),
                           Eigen::Vector3d::Zero());
}

/// K·displacements of one hinge, N, with K = −∂f/∂x. @param whole with what strained hinges add as their
/// bars turn, which may be negative; else K is positive semidefinite
inline HingeVectors stiffnessTimes(const SpringSystem::HingeElement& hinge, const BentHinge& bent, bool whole,
                                   const HingeVectors& displacements) {
    const auto& [edge, across, strain] = bent;
    const Eigen::Vector3d ofEdge = displacements[1] - displacements[0];
    const Eigen::Vector3d ofAcross = displacements[3] - displacements[2];
    const double curvature = hinge.restCurvature;
    const Eigen::Vector3d change =
        betweenBars(hinge, displacements) - curvature * (ofEdge.cross(across) + edge.cross(ofAcross));
    Eigen::Vector3d onEdge = -curvature * across.cross(change), onAcross = -curvature * change.cross(edge);
    if (whole) {
        onEdge -= curvature * ofAcross.cross(strain);
        onAcross -= curvature * strain.cross(ofEdge);
    }
    const double constant = hinge.springConstant;
    return spreadOverNodes(hinge, constant * change, constant * onEdge, constant * onAcross);
}

/// N/m, by which a hinge resists a motion of one of its nodes, at most; `at` is where all of them are.
inline double stiffnessOfNode(const SpringSystem::HingeElement& hinge, std::size_t place,
                              const HingeVectors& at) {
    const double bar = (place < 2 ? at[3] - at[2] : at[1] - at[0]).norm();
    return hinge.springConstant *
           (std::pow(hinge.weights[place], 2) + std::pow(hinge.restCurvature * bar, 2));
}

} // namespace esm
