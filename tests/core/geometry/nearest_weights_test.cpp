#include "core/geometry/nearest_weights.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <random>

using Eigen::Vector3d;
using esm::nearestWeights;

namespace {

using Corners = std::array<Vector3d, 3>;

/// The plane's foot point where it lies inside, else the nearest of the three sides.
double distanceTo(const Corners& p, const Vector3d& point) {
    const Vector3d normal = (p[1] - p[0]).cross(p[2] - p[0]).normalized();
    double nearest = std::numeric_limits<double>::infinity();
    bool inside = true;
    for (std::size_t i = 0; i < 3; ++i) {
        const Vector3d along = p[(i + 1) % 3] - p[i];
        inside = inside && normal.dot(along.cross(point - p[i])) >= 0;
        const double s = std::clamp(along.dot(point - p[i]) / along.squaredNorm(), 0.0, 1.0);
        nearest = std::min(nearest, (p[i] + s * along - point).norm());
    }
    return inside ? std::min(nearest, std::abs(normal.dot(point - p[0]))) : nearest;
}

Vector3d pointAt(const Corners& p, const Vector3d& weights) {
    return weights[0] * p[0] + weights[1] * p[1] + weights[2] * p[2];
}

} // namespace

TEST(NearestWeights, GiveTheNearestPointOfTheTriangle) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> coordinate(-1, 1);
    const auto place = [&] {
        const double x = coordinate(random), y = coordinate(random), z = coordinate(random);
        return Vector3d(x, y, z);
    };
    for (int i = 0; i < 5000; ++i) {
        const Corners corners{place(), place(), place()};
        const Vector3d point = 2 * place();
        const Vector3d weights = nearestWeights(point, corners[0], corners[1], corners[2]);
        EXPECT_NEAR((pointAt(corners, weights) - point).norm(), distanceTo(corners, point), 1e-9);
        EXPECT_NEAR(weights.sum(), 1, 1e-12);
        EXPECT_GE(weights.minCoeff(), 0);
    }
}

TEST(NearestWeights, OfACornerAndASideAreExact) {
    const Corners p{Vector3d(0, 0, 0), Vector3d(4, 0, 0), Vector3d(0, 4, 0)};
    EXPECT_EQ(nearestWeights({-1, -1, 3}, p[0], p[1], p[2]), Vector3d(1, 0, 0));
    EXPECT_EQ(nearestWeights({9, -1, 3}, p[0], p[1], p[2]), Vector3d(0, 1, 0));
    EXPECT_EQ(nearestWeights({0, 7, 3}, p[0], p[1], p[2]), Vector3d(0, 0, 1));
    EXPECT_EQ(nearestWeights({1, -1, 3}, p[0], p[1], p[2]), Vector3d(0.75, 0.25, 0));
    EXPECT_EQ(nearestWeights({1, 2, 3}, p[0], p[1], p[2]), Vector3d(0.25, 0.25, 0.5));
}

TEST(NearestWeights, OfTrianglesWithoutAreaAreNumbers) {
    const Vector3d a(1, 2, 3), b(2, 2, 3), c(4, 2, 3);
    EXPECT_EQ(pointAt({a, a, a}, nearestWeights({0, 0, 0}, a, a, a)), a);
    for (const Corners& corners : {Corners{a, a, c}, Corners{a, c, a}, Corners{c, a, a}, Corners{a, b, c}}) {
        const Vector3d weights = nearestWeights({3, 5, 3}, corners[0], corners[1], corners[2]);
        EXPECT_LT((pointAt(corners, weights) - Vector3d(3, 2, 3)).norm(), 1e-12);
        EXPECT_DOUBLE_EQ(weights.sum(), 1);
        EXPECT_GE(weights.minCoeff(), 0);
    }
}
