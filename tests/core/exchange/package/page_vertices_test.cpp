#include "core/exchange/package/page_vertices.h"

#include "tests/support/test_surfaces.h"

#include <Eigen/Dense>

#include <gtest/gtest.h>

#include <numeric>

using namespace esm;

namespace {

/// A flat square with a network of its vertices, laid out as asked.
Project flatProject(TriangleMesh square, AtlasLayout layout) {
    Project project;
    auto network = std::make_shared<SpringNetwork>();
    network->vertexNodes.resize(square.vertices.size());
    std::iota(network->vertexNodes.begin(), network->vertexNodes.end(), 0U);
    project.network = network;
    project.atlas = std::make_shared<Atlas>(packAtlas(square, {512, 1, 2, layout}));
    project.mesh = std::make_shared<TriangleMesh>(std::move(square));
    return project;
}

struct DrawnSquare {
    PageVertices vertices;
    std::vector<std::uint32_t> triangles;
};

DrawnSquare drawn(const Project& project) {
    const std::vector<Eigen::Vector3d> normals(project.mesh->vertices.size(), Eigen::Vector3d::UnitZ());
    DrawnSquare square;
    square.triangles.resize(project.mesh->triangles.size());
    std::iota(square.triangles.begin(), square.triangles.end(), 0U);
    square.vertices = pageVertices(project, normals, square.triangles, WithTangents::Yes);
    return square;
}

/// In metres of the surface, how far one goes along x when the texture's u grows and v stays: what glTF calls
/// the tangent.
Eigen::Vector3d tangentOf(const TriangleMesh& mesh, std::size_t triangle) {
    const CornerCoordinates& places = mesh.textureCoordinates[triangle];
    const Triangle& corners = mesh.triangles[triangle];
    Eigen::Matrix2d steps;
    steps << places[1] - places[0], places[2] - places[0];
    const Eigen::Vector2d weights = steps.inverse() * Eigen::Vector2d::UnitX();
    const Eigen::Vector3d& origin = mesh.vertices[corners[0]];
    return (weights.x() * (mesh.vertices[corners[1]] - origin) +
            weights.y() * (mesh.vertices[corners[2]] - origin))
        .normalized();
}

} // namespace

TEST(PageVertices, TangentsFollowTheTextureOfEveryCorner) {
    const Project project = flatProject(stretchedSheet(0.1, 4), AtlasLayout::Own);
    const DrawnSquare square = drawn(project);
    EXPECT_EQ(square.vertices.positions.size(), project.mesh->vertices.size()) << "all are shared";
    ASSERT_EQ(square.vertices.tangents.size(), 4 * square.vertices.positions.size());
    for (std::size_t triangle = 0; triangle < square.triangles.size(); ++triangle)
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const float* tangent =
                &square.vertices.tangents[4 * square.vertices.corners[3 * triangle + corner]];
            const Eigen::Vector3d direction(tangent[0], tangent[1], tangent[2]);
            EXPECT_NEAR(direction.norm(), 1, 1e-6);
            EXPECT_NEAR(direction.z(), 0, 1e-6);
            EXPECT_LT((direction - tangentOf(*project.mesh, triangle)).norm(), 0.12)
                << "the mean of neighbours that are stretched a little otherwise";
            EXPECT_EQ(tangent[3], 1);
        }
}

TEST(PageVertices, AMirroredNeighbourHasVerticesOfItsOwn) {
    TriangleMesh mesh = flatSquare(0.1, 2);
    const auto isRight = [](std::size_t triangle) { return triangle / 2 % 2 == 1; };
    // The right half is upside down in the picture: of the line between the halves, its middle alone lies at
    // one place.
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        CornerCoordinates& places = mesh.textureCoordinates.emplace_back();
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const Eigen::Vector3d& vertex = mesh.vertices[mesh.triangles[i][corner]];
            places[corner] = {0.5 + 4 * vertex.x(), 0.5 + (isRight(i) ? -4 : 4) * vertex.y()};
        }
    }
    const Project project = flatProject(std::move(mesh), AtlasLayout::Own);
    const DrawnSquare square = drawn(project);
    EXPECT_EQ(square.vertices.positions.size(), 12) << "six of each half";
    for (std::size_t triangle = 0; triangle < square.triangles.size(); ++triangle)
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const std::uint32_t vertex = square.vertices.corners[3 * triangle + corner];
            EXPECT_NEAR(square.vertices.tangents[4 * vertex], 1, 1e-6);
            EXPECT_EQ(square.vertices.tangents[4 * vertex + 3], isRight(triangle) ? -1 : 1);
        }
}
