#include "core/texture/photo/lens.h"

#include "core/support/parallel_steps.h"
#include "core/texture/photo/photo_sampler.h"

#include <cmath>

namespace esm {

namespace {

/// Brown's model (1966): 1 + k₁r² + k₂r⁴ + k₃r⁶ along the radius, and p₁, p₂ for a lens that is off the axis.
Eigen::Vector2d bentByPinhole(const std::array<double, 5>& c, const Eigen::Vector2d& p) {
    const double square = p.squaredNorm(), xy = p.x() * p.y();
    const double radial = 1 + square * (c[0] + square * (c[1] + square * c[4]));
    return radial * p + Eigen::Vector2d(2 * c[2] * xy + c[3] * (square + 2 * p.x() * p.x()),
                                        c[2] * (square + 2 * p.y() * p.y()) + 2 * c[3] * xy);
}

/// Kannala and Brandt's model (2006): the image's radius is an odd polynomial in the angle to the axis, which
/// stays finite at 90°, where a pinhole's radius does not.
Eigen::Vector2d bentByFisheye(const std::array<double, 5>& c, const Eigen::Vector2d& p) {
    const double radius = p.norm();
    if (radius < 1e-12) return p;
    const double angle = std::atan(radius), square = angle * angle;
    const double bent = angle * (1 + square * (c[0] + square * (c[1] + square * (c[2] + square * c[3]))));
    return bent / radius * p;
}

} // namespace

Eigen::Vector2d distorted(const Lens& lens, const Eigen::Vector2d& place) {
    const Eigen::Array2d focal(lens.camera.fx, lens.camera.fy), centre(lens.camera.cx, lens.camera.cy);
    const Eigen::Vector2d straight = (place.array() - centre) / focal;
    const Eigen::Vector2d bent = lens.kind == LensKind::Pinhole ? bentByPinhole(lens.coefficients, straight)
                                                                : bentByFisheye(lens.coefficients, straight);
    return bent.array() * focal + centre;
}

/// For each straight pixel the place in the photo, and not the other way round: that needs no inverse of the
/// lens and leaves no holes. Places outside stay transparent instead of repeating the border.
Image undistorted(const Image& photo, const Lens& lens, const Progress& progress) {
    Image straight;
    straight.width = photo.width;
    straight.height = photo.height;
    straight.pixels.resize(photo.pixels.size());
    const Eigen::AlignedBox2d all(Eigen::Vector2d::Zero(), Eigen::Vector2d(photo.width, photo.height));
    forEachInParallel(static_cast<std::size_t>(photo.height), progress, [&](std::size_t row) {
        const int y = static_cast<int>(row);
        for (int x = 0; x < photo.width; ++x) {
            const Eigen::Vector2d from = distorted(lens, {x + 0.5, y + 0.5});
            if (!from.allFinite() || !all.contains(from)) continue;
            const Eigen::Vector4f colour = weightedColourAt(photo, from.x(), from.y());
            for (int channel = 0; channel < 4; ++channel)
                straight.at(x, y)[channel] = static_cast<std::uint8_t>(std::lround(colour[channel]));
        }
    });
    return straight;
}

} // namespace esm
