#pragma once

#include "core/render/camera.h"
#include "core/texture/projection/projector.h"

namespace esm {

/// How far the cap of a 6-degree-of-freedom device is pushed and turned: along and about the screen's axes, x
/// right, y up, z towards the viewer, right-handed; 1 is as far as it goes.
struct DeviceMotion {
    Eigen::Vector3d push{0, 0, 0}, turn{0, 0, 0};
    bool isRest() const { return push.isZero() && turn.isZero(); }
};

/// The projector as the device carries it for so many seconds: relative to the screen, in the picture's axes,
/// turned about its own place. A cap pushed all the way moves it by the organ's size (m) in a second, one
/// turned all the way turns it by a right angle.
Projector carried(const Projector& before, const DeviceMotion& motion, const Camera& camera, double organSize,
                  double seconds);

} // namespace esm
