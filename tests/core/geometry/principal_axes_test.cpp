#include "core/geometry/principal_axes.h"

#include <gtest/gtest.h>

namespace esm {
namespace {

using Eigen::Vector3d;

TEST(PrincipalAxes, AreThoseOfABoxWhereverItLies) {
    const Vector3d along = Vector3d(1, 2, 2) / 3, across = Vector3d(2, 1, -2) / 3, up = along.cross(across);
    const Vector3d centre(5, -4, 3);
    std::vector<Vector3d> corners;
    for (const double x : {-3.0, 3.0})
        for (const double y : {-2.0, 2.0})
            for (const double z : {-1.0, 1.0})
                corners.push_back(centre + x * along + y * across + z * up);
    EXPECT_LT((meanOf(corners) - centre).norm(), 1e-12);
    const Eigen::Matrix3d axes = principalAxes(corners);
    EXPECT_NEAR(std::abs(axes.col(2).dot(along)), 1, 1e-12);
    EXPECT_NEAR(std::abs(axes.col(1).dot(across)), 1, 1e-12);
    EXPECT_NEAR(std::abs(axes.col(0).dot(up)), 1, 1e-12);
}

} // namespace
} // namespace esm
