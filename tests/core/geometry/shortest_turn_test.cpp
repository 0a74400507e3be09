#include "core/geometry/shortest_turn.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

using Eigen::Matrix3d;
using Eigen::Vector3d;

namespace {

TEST(ShortestTurn, TurnsOneDirectionToTheOther) {
    const Vector3d from(1, 2, -3);
    for (const Vector3d& to : {Vector3d(4, -1, 2), Vector3d(1, 2, -3.001), Vector3d(-1, -2, 3.0001)}) {
        const Matrix3d turn = esm::shortestTurn(from, to);
        EXPECT_LT((turn * from.normalized() - to.normalized()).norm(), 1e-12);
        EXPECT_LT((turn * turn.transpose() - Matrix3d::Identity()).norm(), 1e-12);
        EXPECT_NEAR(turn.determinant(), 1, 1e-12);
        const Vector3d axis = from.cross(to).normalized();
        EXPECT_LT((turn * axis - axis).norm(), 1e-9) << "what lies across both stays";
    }
}

TEST(ShortestTurn, LeavesWhatIsAlikeAndTurnsTheOpposite) {
    const Vector3d from(0.3, -0.2, 0.1);
    EXPECT_LT((esm::shortestTurn(from, 2 * from) - Matrix3d::Identity()).norm(), 1e-12);
    const Matrix3d half = esm::shortestTurn(from, -from);
    EXPECT_LT((half * from + from).norm(), 1e-12);
    EXPECT_NEAR(half.determinant(), 1, 1e-12);
}

} // namespace
