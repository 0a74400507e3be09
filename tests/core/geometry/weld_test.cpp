#include "core/geometry/weld.h"

#include <gmock/gmock.h>

#include <random>

using namespace esm;
using testing::ElementsAre;

TEST(Weld, JoinsEqualPointsToTheFirst) {
    EXPECT_THAT(weld({{1, 2, 3}, {0, 0, 0}, {1, 2, 3}, {-0.0, 0, -0.0}, {1, 2, 3.0000001}}, 0),
                ElementsAre(0, 1, 0, 1, 4));
    EXPECT_THAT(weld({}, 0), ElementsAre());
}

TEST(Weld, JoinsToTheNearestThatStandsForItself) {
    // 1 joins 0; 2 is near 1 but not near 0, so it stands for itself; 3 is nearer to 2 than to 0.
    EXPECT_THAT(weld({{0, 0, 0}, {0.9, 0, 0}, {1.8, 0, 0}, {1.0, 0, 0}}, 1), ElementsAre(0, 0, 2, 2));
    EXPECT_THAT(weld({{0, 0, 0}, {1, 0, 0}, {2.01, 0, 0}}, 1), ElementsAre(0, 0, 2));
}

TEST(Weld, KeepsToItsDistance) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> coordinate(-1, 1);
    std::vector<Eigen::Vector3d> points;
    for (int i = 0; i < 600; ++i) {
        const double x = coordinate(random), y = coordinate(random), z = coordinate(random);
        points.emplace_back(x, y, z);
    }
    for (const double distance : {1e-9, 0.05, 0.2, 10.0}) {
        const std::vector<std::uint32_t> to = weld(points, distance);
        for (std::size_t i = 0; i < points.size(); ++i) {
            EXPECT_LE(to[i], i);
            EXPECT_EQ(to[to[i]], to[i]);
            EXPECT_LE((points[i] - points[to[i]]).norm(), distance);
            if (to[i] != i) continue;
            for (std::size_t j = 0; j < i; ++j)
                if (to[j] == j) {
                    EXPECT_GT((points[i] - points[j]).norm(), distance);
                }
        }
    }
}
