#pragma once

#include "core/exchange/simulators/mujoco/mujoco_subject.h"

#include <string>

namespace esm {

/// The model that MuJoCo loads, in its XML (MJCF). Units are SI, places those of the project.
///
/// `node12` is a body, with a slide joint for each axis (`node12x`, …) whose place is the node's displacement
/// from rest; its joints' springs are tethers. A fixed node has no joints; a led one is a mocap body.
/// `spring7` is a spatial tendon between the sites of its nodes. Isotropic damping is fixed tendons, see
/// `dampingRows()`, hinges are three fixed tendons each. The scene stands as JSON in the custom text `scene`,
/// since a model holds no loads over time. Pictures of the texture lie beside it.
std::string mujocoModelText(const MujocoSubject& subject);

} // namespace esm
