#pragma once

#include "core/dynamics/settings.h"
#include "core/dynamics/spring_system.h"
#include "core/model/tissue_model.h"

#include <optional>

namespace esm {

/// How fast tissue can swing, and how soon its own viscosity ends that.
struct SwingBounds {
    double largestFrequency = 0; ///< rad/s, at any deformation
    double dampingRatio = 0;     ///< s, least viscosity over spring constant of all that is elastic
};

/// @throws InvalidModel
SwingBounds swingBounds(const TissueModel& model, Damping damping);

/// Whether steps of this length damp away swings that the tissue's viscosity lets go on. Steps of half the
/// length then do the same, and that the two agree says nothing of the swings.
bool hidesSwings(const SwingBounds& bounds, Integrator integrator, double timeStep, double duration);

/// How many steps take about a second; the same on every machine.
double stepsPerSecond(const SpringSystem& system, Integrator integrator);

/// Steps that follow every swing.
struct FollowingSteps {
    Integrator integrator = Integrator::Auto;
    double most = 0; ///< that are worth waiting for, about a minute; the same on every machine
};

/// None where not even the longest stable ones can be waited for. @throws InvalidModel
std::optional<FollowingSteps> followingSteps(const TissueModel& model, Damping damping, double duration);

} // namespace esm
