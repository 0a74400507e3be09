#include "core/surface/surface_query.h"

#include "core/geometry/nearest_weights.h"
#include "core/support/errors.h"
#include "tests/support/test_meshes.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

namespace esm {
namespace {

using test::torus;

/// Moves and scales a mesh: an organ of a few millimetres may lie metres from the origin.
TriangleMesh placed(TriangleMesh mesh, double scale, const Eigen::Vector3d& shift) {
    for (Eigen::Vector3d& vertex : mesh.vertices)
        vertex = scale * vertex + shift;
    return mesh;
}

/// The first hit by asking every triangle in turn.
std::optional<double> bruteHit(const TriangleMesh& mesh, const Ray& ray) {
    std::optional<double> nearest;
    const Eigen::Vector3d direction = ray.direction.normalized();
    for (const Triangle& t : mesh.triangles) {
        Eigen::Matrix3d system;
        system << mesh.vertices[t[1]] - mesh.vertices[t[0]], mesh.vertices[t[2]] - mesh.vertices[t[0]],
            -direction;
        const Eigen::Vector3d solution = system.fullPivLu().solve(ray.origin - mesh.vertices[t[0]]);
        if (solution[0] < 0 || solution[1] < 0 || solution[0] + solution[1] > 1 || solution[2] < 0) continue;
        if (!nearest || solution[2] < *nearest) nearest = solution[2];
    }
    return nearest;
}

struct Placement {
    double scale;
    Eigen::Vector3d shift;
};

void PrintTo(const Placement& placement, std::ostream* out) {
    *out << "size " << placement.scale << " at " << placement.shift.transpose();
}

class SurfaceQueryAt : public testing::TestWithParam<Placement> {
protected:
    TriangleMesh m_mesh = placed(torus(), GetParam().scale, GetParam().shift);
    std::mt19937 m_random{11};

    Eigen::Vector3d randomPoint(double reach) {
        std::uniform_real_distribution<double> coordinate(-reach, reach);
        const double x = coordinate(m_random), y = coordinate(m_random), z = coordinate(m_random);
        return GetParam().scale * Eigen::Vector3d(x, y, z) + GetParam().shift;
    }
};

TEST_P(SurfaceQueryAt, FirstHitAgreesWithEveryTriangleAskedInTurn) {
    const SurfaceQuery query(m_mesh.vertices, m_mesh.triangles);
    int hits = 0;
    for (int i = 0; i < 500; ++i) {
        const Eigen::Vector3d origin = randomPoint(3), target = randomPoint(1.2);
        const Ray ray{origin, target - origin};
        const std::optional<RayHit> hit = query.firstHit(ray);
        const std::optional<double> expected = bruteHit(m_mesh, ray);
        ASSERT_EQ(hit.has_value(), expected.has_value()) << i;
        if (!hit) continue;
        ++hits;
        EXPECT_NEAR(hit->distance, *expected, 1e-9 * GetParam().scale);
        Eigen::Vector3d place = Eigen::Vector3d::Zero();
        for (std::size_t c = 0; c < 3; ++c)
            place +=
                hit->barycentric[static_cast<int>(c)] * m_mesh.vertices[m_mesh.triangles[hit->triangle][c]];
        EXPECT_LT((place - ray.origin - hit->distance * ray.direction.normalized()).norm(),
                  1e-9 * GetParam().scale);
    }
    EXPECT_GT(hits, 100);
    EXPECT_LT(hits, 450);
}

INSTANTIATE_TEST_SUITE_P(Placements, SurfaceQueryAt,
                         testing::Values(Placement{1, {0, 0, 0}}, Placement{0.004, {1.7, -0.3, 0.9}},
                                         Placement{250, {-90, 4000, 12}}));

TEST(SurfaceQuery, FindsTheNearestPointAsAskingEveryTriangleDoes) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> anywhere(-2, 2);
    for (const double scale : {1.0, 0.005}) {
        const Eigen::Vector3d shift(3, -1, 2);
        const TriangleMesh mesh = placed(torus(20, 12), scale, shift);
        const SurfaceQuery query(mesh.vertices, mesh.triangles);
        for (int i = 0; i < 200; ++i) {
            const Eigen::Vector3d point =
                scale * Eigen::Vector3d(anywhere(random), anywhere(random), anywhere(random)) + shift;
            double least = std::numeric_limits<double>::infinity();
            for (const Triangle& t : mesh.triangles) {
                const Eigen::Vector3d w =
                    nearestWeights(point, mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]);
                least = std::min(least, (w[0] * mesh.vertices[t[0]] + w[1] * mesh.vertices[t[1]] +
                                         w[2] * mesh.vertices[t[2]] - point)
                                            .norm());
            }
            const auto nearest = query.nearest(point);
            ASSERT_TRUE(nearest);
            ASSERT_DOUBLE_EQ(nearest->distance, least);
        }
        EXPECT_FALSE(query.nearest({NAN, 0, 0}));
    }
}

TEST(SurfaceQuery, MeetsTheSurfaceFromEitherSideAndFromFarAway) {
    const TriangleMesh mesh = torus(48, 24);
    const SurfaceQuery query(mesh.vertices, mesh.triangles);
    const auto outside = query.firstHit({{5, 0, 0}, {-7, 0, 0}});
    ASSERT_TRUE(outside);
    EXPECT_NEAR(outside->distance, 5 - 1.3, 1e-12);
    const auto inside = query.firstHit({{1, 0, 0}, {1, 0, 0}});
    ASSERT_TRUE(inside);
    EXPECT_NEAR(inside->distance, 0.3, 1e-12);
    const auto far = query.firstHit({{1e6, 0, 0}, {-1, 0, 0}});
    ASSERT_TRUE(far);
    EXPECT_NEAR(far->distance, 1e6 - 1.3, 1e-6);
    EXPECT_FALSE(query.firstHit({{0, 0, 0}, {0, 0, 1}})) << "through the hole";
}

TEST(SurfaceQuery, BlocksOnlyWhatLiesBetweenTheMargins) {
    const TriangleMesh mesh = torus(48, 24);
    const SurfaceQuery query(mesh.vertices, mesh.triangles);
    EXPECT_TRUE(query.isBlocked({3, 0, 0}, {0, 0, 0}, 0));
    EXPECT_FALSE(query.isBlocked({0, 0, -3}, {0, 0, 3}, 0)) << "through the hole";
    EXPECT_FALSE(query.isBlocked({3, 0, 0}, {1.31, 0, 0}, 0));
    EXPECT_FALSE(query.isBlocked({3, 0, 0}, {1.3, 0, 0}, 1e-4)) << "a point on the surface is seen";
    EXPECT_TRUE(query.isBlocked({3, 0, 0}, {-1.3, 0, 0}, 1e-4)) << "the far side is not";
    EXPECT_FALSE(query.isBlocked({1, 0, 0}, {1, 0, 0}, 0));
}

TEST(SurfaceQuery, FollowsTheSurfaceWhenItMoves) {
    TriangleMesh mesh = torus();
    SurfaceQuery query(mesh.vertices, mesh.triangles);
    for (int step = 0; step < 5; ++step) {
        for (Eigen::Vector3d& vertex : mesh.vertices)
            vertex = Eigen::Vector3d(1.1 * vertex.x() + 0.4 * vertex.y(), vertex.y() + 0.3, vertex.z() - 2);
        query.refit(mesh.vertices);
        const SurfaceQuery fresh(mesh.vertices, mesh.triangles);
        for (const Eigen::Vector3d& target : mesh.vertices) {
            const Ray ray{{10, 20, 30}, target * 0.99 - Eigen::Vector3d(10, 20, 30)};
            const auto hit = query.firstHit(ray), expected = fresh.firstHit(ray);
            ASSERT_EQ(hit.has_value(), expected.has_value());
            if (hit) {
                EXPECT_NEAR(hit->distance, expected->distance, 1e-9);
            }
        }
    }
}

TEST(SurfaceQuery, RefusesPositionsThatAreNotFiniteAndKeepsWhatItHad) {
    const TriangleMesh mesh = torus();
    SurfaceQuery query(mesh.vertices, mesh.triangles);
    std::vector<Eigen::Vector3d> broken = mesh.vertices;
    broken[17].z() = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(query.refit(broken), InvalidModel);
    EXPECT_THROW(query.refit({}), InvalidModel);
    EXPECT_THROW(SurfaceQuery(broken, mesh.triangles), InvalidModel);
    EXPECT_THROW(SurfaceQuery({}, mesh.triangles), InvalidModel);
    EXPECT_TRUE(query.firstHit({{5, 0, 0.01}, {-1, 0, 0}}));
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(query.firstHit({{nan, 0, 0}, {-1, 0, 0}}));
    EXPECT_FALSE(query.firstHit({{5, 0, 0}, {0, 0, 0}}));
    EXPECT_FALSE(query.isBlocked({nan, 0, 0}, {0, 0, 0}, 0));
}

TEST(SurfaceQuery, OfNothingFindsNothing) {
    const SurfaceQuery query({}, {});
    EXPECT_FALSE(query.firstHit({{5, 0, 0}, {-1, 0, 0}}));
    EXPECT_FALSE(query.isBlocked({5, 0, 0}, {-5, 0, 0}, 0));
}

} // namespace
} // namespace esm
