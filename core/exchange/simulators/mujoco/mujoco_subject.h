#pragma once

#include "core/dynamics/spring_system.h"
#include "core/exchange/simulators/handover.h"
#include "core/exchange/simulators/mujoco/damping_rows.h"
#include "core/exchange/simulators/mujoco/mujoco_step.h"

#include <vector>

namespace esm {

/// Nodes that are handed to MuJoCo at most. It keeps a full row of all joints for every tendon.
inline constexpr std::size_t mostMujocoNodes = 2500;

/// What a model of MuJoCo is written from.
struct MujocoSubject {
    const Handover& handover;
    const SpringSystem& system; ///< of its tissue
    Damping damping;
    std::vector<char> led;        ///< by node: the scene leads it along a path
    std::vector<char> still;      ///< by node: it has no joints, since it is led or fixed
    std::vector<DampingRow> rows; ///< of isotropic damping
    MujocoStep step;
};

/// @param system of the handover's tissue
/// @throws InvalidModel with the reason for what MuJoCo cannot hold or step; Cancelled
MujocoSubject mujocoSubject(const Handover& handover, const SpringSystem& system, const HandoverMeans& means);

/// The longest step that is stable with the subject's armature, s; infinite where there is no limit.
/// @throws Cancelled
double largestStepOf(const MujocoSubject& subject, const Progress& progress = {});

/// Whether it pulls at a node that moves.
inline bool isMovable(const MujocoSubject& subject, const SpringSystem::Element& spring) {
    return !subject.still[spring.first] || !subject.still[spring.second];
}
inline bool isMovable(const MujocoSubject& subject, const SpringSystem::HingeElement& hinge) {
    for (std::size_t i = 0; i < hinge.nodes.size(); ++i)
        if (!subject.still[hinge.nodes[i]] && hinge.weights[i] != 0) return true;
    return false;
}

} // namespace esm
