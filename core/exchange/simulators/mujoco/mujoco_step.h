#pragma once

#include "core/dynamics/spring_system.h"
#include "core/model/tissue_model.h"
#include "core/support/progress.h"

#include <optional>
#include <vector>

namespace esm {

/// s, by which motion may come later where no step is asked for.
inline constexpr double mostMujocoLag = 0.001;

/// s, by which motion that comes later is some hundredth off: see `MujocoStep`.
inline constexpr double noticedMujocoLag = 0.004;

/// How MuJoCo steps a tissue by its semi-implicit Euler. Springs and what is damped between nodes it takes
/// explicitly; joints' own damping, which is that of tethers, implicitly. Its "implicit" takes of damping
/// between nodes only what each node has of it, and needs a matrix of all velocities in 2.2.2.
///
/// Where viscosity outweighs inertia an explicit step would have to be of microseconds. Joints then have
/// armature, which is inertia that weighs nothing: with
///
///   m + armature ≥ h·D/2 + h²·K/4,
///
/// D and K what the node's rows of the matrices of viscosities and spring constants come to (sums without
/// signs), Gershgorin's circles say that a step h is stable at every deformation. Armature is in proportion
/// to the step. It makes slow motion come later, by the largest eigenvalue of D⁻¹·armature: a tube of the
/// published tissue [R C.1] that is pressed for 0.3 s is off by 0.9 % of its motion with a lag of 3.5 ms, in
/// proportion. An organ that little holds comes much later, and is better off with short steps.
struct MujocoStep {
    double timeStep;              ///< s
    std::vector<double> armature; ///< kg, by node; 0 where the mass is enough
    double largestPlain; ///< s, the longest stable step without any; infinite where there is no limit
    double lag;          ///< s, at most, by which armature makes motion come later
};

/// What has joints to move by.
struct MujocoJoints {
    const SpringSystem& system;     ///< of the tissue
    const std::vector<char>& still; ///< by node: it has none, since it is fixed or led
};

/// @param timeStep s, that is asked for; what suits the tissue without @throws Cancelled
MujocoStep mujocoStep(const TissueModel& tissue, const MujocoJoints& joints, std::optional<double> timeStep,
                      const Progress& progress = {});

/// s, the longest step that is stable with this armature; infinite where there is no limit. Predicted as of
/// isotropic damping, of which axial damping is a part. @throws Cancelled
double largestMujocoStep(const TissueModel& tissue, const std::vector<double>& armature,
                         const Progress& progress = {});

} // namespace esm
