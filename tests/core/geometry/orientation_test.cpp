#include "core/geometry/orientation.h"

#include "core/geometry/adjacency.h"
#include "tests/support/test_meshes.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace esm;

namespace {

void turn(Triangle& triangle) {
    std::swap(triangle[1], triangle[2]);
}

std::size_t turnedOf(TriangleMesh& mesh) {
    const std::vector<bool> turned = orientTriangles(mesh.vertices, mesh.triangles);
    EXPECT_EQ(turned.size(), mesh.triangles.size());
    return static_cast<std::size_t>(std::count(turned.begin(), turned.end(), true));
}

} // namespace

TEST(OrientTriangles, LeavesWhatFacesOutwards) {
    TriangleMesh mesh = test::torus();
    const std::vector<Triangle> before = mesh.triangles;
    EXPECT_EQ(turnedOf(mesh), 0);
    EXPECT_EQ(mesh.triangles, before);
}

TEST(OrientTriangles, TurnsAClosedSurfaceOutwardsWhateverTheMostFace) {
    const TriangleMesh outward = test::torus();
    for (const std::size_t every : {1U, 2U, 3U, 7U}) {
        TriangleMesh mesh = outward;
        std::size_t turned = 0;
        for (std::size_t i = 0; i < mesh.triangles.size(); i += every, ++turned)
            turn(mesh.triangles[i]);
        EXPECT_EQ(turnedOf(mesh), turned);
        EXPECT_NEAR(enclosedVolume(mesh), enclosedVolume(outward), 1e-12);
        EXPECT_TRUE(countEdges(sidesByEdge(mesh.triangles)).isClosed());
    }
}

TEST(OrientTriangles, DoesNotDependOnWhereTheSurfaceLies) {
    TriangleMesh mesh = test::torus();
    for (Eigen::Vector3d& vertex : mesh.vertices)
        vertex += Eigen::Vector3d(1e5, -1e5, 1e5);
    for (Triangle& triangle : mesh.triangles)
        turn(triangle);
    EXPECT_EQ(turnedOf(mesh), mesh.triangles.size());
}

TEST(OrientTriangles, LetsAnOpenSurfaceFaceAsMostOfItDoes) {
    TriangleMesh mesh = test::torus();
    mesh.triangles.resize(100);
    for (std::size_t i = 0; i < 60; ++i)
        turn(mesh.triangles[i]);
    const std::vector<Triangle> before = mesh.triangles;
    EXPECT_EQ(turnedOf(mesh), 40);
    EXPECT_EQ(mesh.triangles[0], before[0]);
    EXPECT_EQ(countEdges(sidesByEdge(mesh.triangles)).inconsistent, 0);
}
