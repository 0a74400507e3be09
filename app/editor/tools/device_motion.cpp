#include "app/editor/tools/device_motion.h"

#include "core/support/angles.h"

namespace esm {

Projector carried(const Projector& before, const DeviceMotion& motion, const Camera& camera, double organSize,
                  double seconds) {
    const Eigen::Matrix3d axes = cameraAxes(camera);
    Projector after = before;
    after.pose.translation() += axes * motion.push * (organSize * seconds);
    const Eigen::Vector3d turn = axes * motion.turn * (pi / 2 * seconds);
    if (turn.isZero()) return after;
    const Eigen::Matrix3d turned =
        Eigen::AngleAxisd(turn.norm(), turn.normalized()).toRotationMatrix() * before.pose.linear();
    // What many small turns add up to stays a rotation.
    after.pose.linear() = Eigen::Quaterniond(turned).normalized().toRotationMatrix();
    return after;
}

} // namespace esm
