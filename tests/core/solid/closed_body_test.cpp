#include "core/solid/closed_body.h"

#include "core/support/errors.h"
#include "tests/support/rounds.h"
#include "tests/support/solid_surfaces.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

namespace esm {
namespace {

using Eigen::Vector3d;
using testing::HasSubstr;

std::string refusal(const TriangleMesh& mesh) {
    try {
        closedBodiesOf(mesh);
    } catch (const InvalidModel& error) {
        EXPECT_EQ(error.problems().size(), 1U);
        return error.what();
    }
    return "";
}

TEST(ClosedBodies, AreFoundWithTheirCavitiesWhicheverWayTheyFace) {
    TriangleMesh mesh = test::ball(1, {0, 0, 0});
    test::append(mesh, test::ball(0.6, {0.1, 0, 0}));               // a cavity that faces outwards
    test::append(mesh, test::turned(test::ball(0.3, {0.2, 0, 0}))); // a body within that faces inwards
    test::append(mesh, test::turned(test::ball(0.5, {3, 0, 0})));   // one beside it
    const std::vector<ClosedBody> bodies = closedBodiesOf(mesh);
    ASSERT_EQ(bodies.size(), 3U);
    const double unit = enclosedVolume(test::ball(1, {0, 0, 0}));
    EXPECT_NEAR(bodies[0].volume, unit * (1 - std::pow(0.6, 3)), 1e-9);
    EXPECT_NEAR(bodies[1].volume, unit * std::pow(0.3, 3), 1e-9);
    EXPECT_NEAR(bodies[2].volume, unit * std::pow(0.5, 3), 1e-9);
    for (const ClosedBody& body : bodies)
        EXPECT_NEAR(enclosedVolume(body.surface), body.volume, 1e-12);
}

/// Whether a point lies within, by the parity of crossings along a ray that asks every triangle.
bool isWithinByParity(const TriangleMesh& mesh, const Vector3d& point, const Vector3d& direction) {
    int crossings = 0;
    for (const Triangle& t : mesh.triangles) {
        Eigen::Matrix3d system;
        system << mesh.vertices[t[1]] - mesh.vertices[t[0]], mesh.vertices[t[2]] - mesh.vertices[t[0]],
            -direction;
        const Vector3d solution = system.fullPivLu().solve(point - mesh.vertices[t[0]]);
        if (solution[0] >= 0 && solution[1] >= 0 && solution[0] + solution[1] <= 1 && solution[2] >= 0)
            ++crossings;
    }
    return crossings % 2 == 1;
}

TEST(BodyQuery, KnowsInsideFromOutside) {
    std::mt19937 random(seedOf(0));
    std::uniform_real_distribution<double> place(-1.2, 1.2);
    for (TriangleMesh mesh : {lumpySurface(20, 40), test::torus(24, 12), test::shell(1, 0.7)}) {
        const double size = boundingBox(mesh.vertices).sizes().maxCoeff() / 2;
        const std::vector<ClosedBody> bodies = closedBodiesOf(mesh);
        ASSERT_EQ(bodies.size(), 1U);
        const BodyQuery query(bodies[0]);
        for (int i = 0; i < 400; ++i) {
            const Vector3d point = size * Vector3d(place(random), place(random), place(random));
            const Vector3d direction(place(random), place(random), place(random));
            EXPECT_EQ(query.contains(point), isWithinByParity(mesh, point, direction)) << point.transpose();
            EXPECT_NEAR(windingNumber(bodies[0].surface, point), query.contains(point) ? 1 : 0, 1e-9);
        }
    }
}

TEST(ClosedBodies, RefuseAnOpenSurfaceAndSayWhereItIsOpen) {
    TriangleMesh mesh = test::torus(24, 12);
    mesh.triangles.resize(mesh.triangles.size() - 4);
    const std::string message = refusal(mesh);
    EXPECT_THAT(message, HasSubstr("6 open edges in 1 borders, the longest of 6 edges"));
    EXPECT_THAT(message, HasSubstr("close slits and fill holes"));
    EXPECT_THAT(message, HasSubstr("a wall of prisms"));
}

TEST(ClosedBodies, RefuseASurfaceThatTurnsItsInsideOut) {
    TriangleMesh mesh = test::torus(24, 12);
    std::swap(mesh.triangles[7][0], mesh.triangles[7][1]);
    EXPECT_THAT(refusal(mesh), HasSubstr("at 3 edges it turns its inside out"));
}

TEST(ClosedBodies, RefuseASurfaceThatRunsThroughItselfAndEnclosesNothing) {
    // An eight in the round: as much is wound one way as the other.
    TriangleMesh mesh = test::torus(24, 12);
    const double middle = boundingBox(mesh.vertices).center().x();
    for (Eigen::Vector3d& vertex : mesh.vertices)
        vertex.y() *= vertex.x() > middle ? 1 : -1;
    EXPECT_THAT(refusal(mesh), HasSubstr("the surface runs through itself"));
}

TEST(ClosedBodies, RefuseWhatEnclosesNothing) {
    EXPECT_THAT(refusal({}), HasSubstr("no surface to fill"));
    const TriangleMesh flat{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 1}}};
    EXPECT_THAT(refusal(flat), HasSubstr("encloses nothing"));
}

} // namespace
} // namespace esm
