#pragma once

#include "core/support/angles.h"
#include "core/texture/projection/pose_fit.h"

#include <cmath>
#include <random>

namespace esm::test {

inline constexpr PhotoSize endoscope{1920, 1080};
inline const double diagonal = std::hypot(endoscope.width, endoscope.height);

/// A camera as the liver's in the test data: an endoscope 0.3 m away with its line of sight off the middle.
inline Projector camera() {
    Projector projector;
    projector.kind = ProjectorKind::Perspective;
    projector.intrinsics = Intrinsics{2012.186314, 2017.966019, 944.7173708, 617.1093984};
    projector.pose = Eigen::Translation3d(0.117, -0.23, -0.172) *
                     Eigen::AngleAxisd(2, Eigen::Vector3d(1, -0.4, 0.3).normalized());
    return projector;
}

/// Landmarks all over what the camera sees, as deep as an organ is.
inline std::vector<LandmarkPair> pairsSeenBy(const Projector& projector, std::size_t count,
                                             unsigned seed = 1) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> share(0.05, 0.95), depth(0.25, 0.4);
    const Intrinsics seen = intrinsicsOf(projector, endoscope);
    std::vector<LandmarkPair> pairs;
    while (pairs.size() < count) {
        const Eigen::Vector2d pixel(share(random) * endoscope.width, share(random) * endoscope.height);
        const double z = depth(random);
        const Eigen::Vector3d own((pixel.x() - seen.cx) / seen.fx * z, -(pixel.y() - seen.cy) / seen.fy * z,
                                  -z);
        pairs.push_back({pixel, projector.pose * own});
    }
    return pairs;
}

inline void addNoise(std::vector<LandmarkPair>& pairs, double pixels, unsigned seed = 7) {
    std::mt19937 random(seed);
    std::normal_distribution<double> noise(0, pixels);
    for (LandmarkPair& pair : pairs)
        pair.photo += Eigen::Vector2d(noise(random), noise(random));
}

/// How far off a pose shows points that the true camera sees, pixels, root of the mean square.
inline double errorAt(const Projector& found, const Projector& truth) {
    double squares = 0;
    const std::vector<LandmarkPair> everywhere = pairsSeenBy(truth, 200, 99);
    for (const LandmarkPair& pair : everywhere) {
        const auto place = project(found, endoscope, pair.organ);
        if (!place) return HUGE_VAL;
        squares += (place->head<2>() - pair.photo).squaredNorm();
    }
    return std::sqrt(squares / double(everywhere.size()));
}

} // namespace esm::test
