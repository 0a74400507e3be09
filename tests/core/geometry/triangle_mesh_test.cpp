#include "core/geometry/triangle_mesh.h"

#include "tests/support/test_meshes.h"
#include "tests/support/tissue_models.h"

#include <gmock/gmock.h>

using namespace esm;
using testing::ElementsAre;

namespace {

constexpr double pi = 3.14159265358979323846;

} // namespace

TEST(TriangleMesh, OfASphereHasItsAreaAndVolume) {
    const TriangleMesh coarse = tissue::sphereMesh(3, 0.5), fine = tissue::sphereMesh(5, 0.5);
    const double area = 4 * pi * 0.25, volume = 4.0 / 3 * pi * 0.125;
    EXPECT_NEAR(surfaceArea(fine), area, 2e-3 * area);
    EXPECT_NEAR(enclosedVolume(fine), volume, 3e-3 * volume);
    // Both fall short by the square of the triangles' size.
    EXPECT_NEAR((area - surfaceArea(coarse)) / (area - surfaceArea(fine)), 16, 1);
    EXPECT_NEAR((volume - enclosedVolume(coarse)) / (volume - enclosedVolume(fine)), 16, 1);
}

TEST(TriangleMesh, EnclosesTheSameVolumeWhereverItLies) {
    TriangleMesh mesh = test::torus();
    const double volume = enclosedVolume(mesh);
    for (Eigen::Vector3d& vertex : mesh.vertices)
        vertex += Eigen::Vector3d(1e6, -2e6, 3e6);
    EXPECT_NEAR(enclosedVolume(mesh), volume, 1e-8);
    for (Triangle& triangle : mesh.triangles)
        std::swap(triangle[0], triangle[1]);
    EXPECT_NEAR(enclosedVolume(mesh), -volume, 1e-8);
    EXPECT_EQ(enclosedVolume({}), 0);
}

TEST(VertexNormals, OfASpherePointAwayFromItsCentre) {
    const TriangleMesh mesh = tissue::sphereMesh(4, 2);
    const auto normals = vertexNormals(mesh.vertices, mesh.triangles);
    ASSERT_EQ(normals.size(), mesh.vertices.size());
    for (std::size_t i = 0; i < normals.size(); ++i) {
        EXPECT_NEAR(normals[i].norm(), 1, 1e-12);
        EXPECT_GT(normals[i].dot(mesh.vertices[i].normalized()), 0.9995);
    }
}

TEST(VertexNormals, AreDefinedWhereThereIsNoArea) {
    const auto normals = vertexNormals({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {5, 5, 5}}, {{0, 1, 2}});
    for (const Eigen::Vector3d& normal : normals)
        EXPECT_EQ(normal, Eigen::Vector3d::UnitZ());
}

TEST(UniqueEdges, ComeOnceInTheOrderOfTheirFirstUse) {
    EXPECT_THAT(uniqueEdges({{0, 2, 1}, {1, 2, 3}}),
                ElementsAre(Edge{0, 2}, Edge{1, 2}, Edge{0, 1}, Edge{2, 3}, Edge{1, 3}));
    const TriangleMesh torus = test::torus();
    EXPECT_EQ(uniqueEdges(torus.triangles).size(), 3 * torus.triangles.size() / 2);
}

TEST(BoundingBox, HoldsEveryPoint) {
    EXPECT_TRUE(boundingBox({}).isEmpty());
    const auto box = boundingBox({{1, -2, 3}, {-1, 5, 0}});
    EXPECT_EQ(box.min(), Eigen::Vector3d(-1, -2, 0));
    EXPECT_EQ(box.max(), Eigen::Vector3d(1, 5, 3));
}
