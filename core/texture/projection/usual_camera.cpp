#include "core/texture/projection/usual_camera.h"

#include "core/support/angles.h"

#include <cmath>

namespace esm {

namespace {

constexpr double degreesOfFreedom = 3;

/// Of Student's distribution in some dimensions, for what is off by `off` at this scale.
template<int dimensions>
void addStudent(Unlikeliness& all, Eigen::Index first, const Eigen::Matrix<double, dimensions, 1>& off,
                double scale) {
    const double share = off.squaredNorm() / (degreesOfFreedom * scale * scale);
    const double weight = (degreesOfFreedom + dimensions) / (degreesOfFreedom * scale * scale * (1 + share));
    all.value += (degreesOfFreedom + dimensions) * std::log1p(share);
    all.gradient.segment<dimensions>(first) += weight * off;
    all.curvature.segment<dimensions>(first).array() += weight;
}

} // namespace

/// Endoscopes see 40 to 100°, a photo from afar 10°. Their principal points lie within some hundredths of the
/// diagonal of the middle, and pixels that are not square come from video standards (1.07 to 1.46).
UsualCamera usualCamera(PhotoSize photo) {
    const double focalLength = photo.height / (2 * std::tan(toRadians(assumedFieldOfView) / 2));
    return {{focalLength, focalLength, photo.width / 2.0, photo.height / 2.0},
            0.35,
            0.04 * std::hypot(photo.width, photo.height),
            0.005};
}

Unlikeliness unlikeliness(const UsualCamera& usual, const Intrinsics& camera) {
    Unlikeliness all;
    using One = Eigen::Matrix<double, 1, 1>;
    addStudent<1>(all, camera_step::focalLength, One(std::log(camera.fy / usual.camera.fy)),
                  usual.focalScale);
    addStudent<2>(all, camera_step::principalPoint,
                  Eigen::Vector2d(camera.cx - usual.camera.cx, camera.cy - usual.camera.cy),
                  usual.principalScale);
    addStudent<1>(all, camera_step::pixelAspect, One(std::log(camera.fx / camera.fy)), usual.aspectScale);
    return all;
}

} // namespace esm
