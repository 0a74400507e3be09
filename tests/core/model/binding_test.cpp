#include "core/project/simulated_network.h"

#include "core/geometry/adjacency.h"
#include "core/support/errors.h"
#include "tests/support/test_meshes.h"
#include "tests/support/test_surfaces.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

using namespace esm;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

namespace {

using Points = std::vector<Eigen::Vector3d>;

SpringNetwork coarse(const TriangleMesh& mesh, std::size_t nodes) {
    return networkOf(mesh, {Detail::Kind::Nodes, nodes});
}

Points moved(const Points& points, const std::function<Eigen::Vector3d(const Eigen::Vector3d&)>& motion) {
    Points result;
    for (const Eigen::Vector3d& point : points)
        result.push_back(motion(point));
    return result;
}

double farthest(const Points& a, const Points& b) {
    double most = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        most = std::max(most, (a[i] - b[i]).norm());
    return most;
}

/// How far the drawn vertices are from where the motion would take them.
double deviation(const TriangleMesh& mesh, const SpringNetwork& network,
                 const std::function<Eigen::Vector3d(const Eigen::Vector3d&)>& motion) {
    return farthest(drawnPositions(mesh, network, moved(network.restPositions, motion)),
                    moved(mesh.vertices, motion));
}

Eigen::Vector3d same(const Eigen::Vector3d& point) {
    return point;
}

const Eigen::Quaterniond turn(Eigen::AngleAxisd(2.1, Eigen::Vector3d(1, -2, 0.5).normalized()));

Eigen::Vector3d turnedAway(const Eigen::Vector3d& point) {
    return turn * point + Eigen::Vector3d(0.3, -0.2, 0.7);
}

/// Two sheets 1 mm apart that are one closed part, and a small ball that touches neither.
TriangleMesh thinSheetAndBall() {
    TriangleMesh mesh = lumpySurface(24, 48);
    for (Eigen::Vector3d& vertex : mesh.vertices)
        vertex.y() *= 0.01;
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    const TriangleMesh ball = test::torus(12, 8, 0.004, 0.002);
    for (const Eigen::Vector3d& vertex : ball.vertices)
        mesh.vertices.emplace_back(vertex + Eigen::Vector3d(0.02, 0.004, 0));
    for (const Triangle& t : ball.triangles)
        mesh.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
    return mesh;
}

} // namespace

TEST(BindingToASurface, ReproducesTheSurfaceAtRest) {
    for (const TriangleMesh& mesh : {lumpySurface(30, 60), flatSquare(0.1, 20), thinSheetAndBall()}) {
        const SpringNetwork network = coarse(mesh, 120);
        ASSERT_TRUE(network.binding);
        EXPECT_THAT(validate(*network.binding, mesh.vertices.size(), network.restPositions.size()),
                    IsEmpty());
        EXPECT_LT(deviation(mesh, network, same), 1e-12 * 0.1);
    }
}

TEST(BindingToASurface, FollowsATurnAndAShiftExactly) {
    const TriangleMesh mesh = thinSheetAndBall();
    EXPECT_LT(deviation(mesh, coarse(mesh, 120), turnedAway), 1e-13);
}

TEST(BindingToASurface, FollowsALinearDeformation) {
    const TriangleMesh mesh = lumpySurface(40, 80);
    Eigen::Matrix3d stretch;
    stretch << 1.2, 0.1, 0, -0.05, 0.9, 0.1, 0, 0.2, 1.1;
    const auto motion = [&](const Eigen::Vector3d& point) -> Eigen::Vector3d { return stretch * point; };
    const double motionItself = farthest(moved(mesh.vertices, motion), mesh.vertices);
    EXPECT_LT(deviation(mesh, coarse(mesh, 300), motion), 0.06 * motionItself);
    // A flat surface has no height over its triangles, so that nothing is left out.
    const TriangleMesh flat = flatSquare(0.1, 20);
    EXPECT_LT(deviation(flat, coarse(flat, 40), motion), 1e-6 * 0.1);
}

TEST(BindingToASurface, FollowsABendBetterThanTheTrianglesDo) {
    const TriangleMesh mesh = lumpySurface(40, 80);
    const auto motion = [](const Eigen::Vector3d& p) -> Eigen::Vector3d {
        return {p.x(), p.y() + 3 * p.x() * p.x() + 0.5 * p.z() * p.x(), p.z()};
    };
    double last = 0.03;
    for (const std::size_t nodes : {100U, 400U, 1600U}) {
        const double now = deviation(mesh, coarse(mesh, nodes), motion);
        EXPECT_LT(now, 0.5 * last) << nodes;
        last = now;
    }
}

TEST(BindingToASurface, KeepsItsNodesWhereTheyAre) {
    const TriangleMesh mesh = lumpySurface(30, 60);
    const SpringNetwork network = coarse(mesh, 200);
    Points positions = network.restPositions;
    for (std::size_t i = 0; i < positions.size(); ++i)
        positions[i] += 0.01 * Eigen::Vector3d(std::sin(double(i)), std::cos(3.0 * double(i)), 0.2);
    const Points drawn = drawnPositions(mesh, network, positions);
    std::size_t found = 0;
    for (std::size_t i = 0; i < drawn.size(); ++i) {
        if (network.binding->vertices[i].shares[0] != 1) continue;
        const std::uint32_t node = network.vertexNodes[i];
        if (mesh.vertices[i] != network.restPositions[node]) continue;
        EXPECT_LT((drawn[i] - positions[node]).norm(), 1e-15);
        ++found;
    }
    EXPECT_EQ(found, network.restPositions.size());
}

TEST(BindingToASurface, StaysFiniteWhereTrianglesLoseTheirArea) {
    const TriangleMesh mesh = lumpySurface(20, 40);
    const SpringNetwork network = coarse(mesh, 60);
    for (const double scale : {0.0, 1e-200, 1e8}) {
        const auto motion = [scale](const Eigen::Vector3d& point) -> Eigen::Vector3d {
            return {scale * point.x(), 0, 0};
        };
        for (const Eigen::Vector3d& point :
             drawnPositions(mesh, network, moved(network.restPositions, motion)))
            ASSERT_TRUE(point.allFinite()) << scale;
    }
}

TEST(BindingToASurface, BindsToItsOwnPartAndItsOwnSide) {
    const TriangleMesh mesh = thinSheetAndBall();
    const SpringNetwork network = coarse(mesh, 160);
    const Parts parts = connectedParts(mesh.triangles, mesh.vertices.size());
    ASSERT_EQ(parts.count, 2U);
    std::vector<std::uint32_t> partOf(mesh.vertices.size());
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
        for (const std::uint32_t vertex : mesh.triangles[i])
            partOf[vertex] = parts.ofTriangle[i];
    std::vector<std::uint32_t> partOfNode(network.restPositions.size());
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i)
        if (mesh.vertices[i] == network.restPositions[network.vertexNodes[i]])
            partOfNode[network.vertexNodes[i]] = partOf[i];
    const Points normals = vertexNormals(mesh.vertices, mesh.triangles);
    std::size_t astray = 0;
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        const auto nodes = network.binding->vertices[i].nodes;
        for (const std::uint32_t node : nodes)
            ASSERT_EQ(partOfNode[node], partOf[i]) << i;
        const auto& at = network.restPositions;
        const std::uint32_t a = nodes[0], b = nodes[1], c = nodes[2];
        astray += (at[b] - at[a]).cross(at[c] - at[a]).dot(normals[i]) < 0;
    }
    EXPECT_LT(astray, mesh.vertices.size() / 50);
}

TEST(BindingToASurface, IsTheSameEveryTime) {
    const TriangleMesh mesh = lumpySurface(20, 40);
    const SpringNetwork first = coarse(mesh, 100), second = coarse(mesh, 100);
    EXPECT_EQ(first.vertexNodes, second.vertexNodes);
    EXPECT_TRUE(first.binding->vertices == second.binding->vertices);
}

TEST(Binding, SaysEverythingThatIsWrongWithIt) {
    Binding binding;
    binding.surface = {{0, 1, 2}, {0, 1, 9}};
    binding.lines = {{0, 0}};
    binding.vertices = {{0, 3, 6, 9, 12},
                        {0, 1, 2, 0, 1, 3, 0, 1, 2, 0, 1, 2},
                        {0.5, 0.5, 0, 1, 0, 0, 0.5, 0.4, 0, NAN, 1, 0}};
    const auto problems = validate(binding, 5, 3);
    EXPECT_THAT(problems, Contains(HasSubstr("4 of 5 drawn vertices")));
    EXPECT_THAT(problems, Contains(HasSubstr("3 drawn points")));
    EXPECT_THAT(problems, Contains(HasSubstr("simulated triangle 1")));
    EXPECT_THAT(problems, Contains(HasSubstr("line 0")));
}

TEST(DrawnPositions, KeepTheirPlaceAtTheirNodeWithoutABinding) {
    TriangleMesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, {{0, 1, 2}, {1, 3, 2}}};
    SpringNetwork network = networkFromMesh(mesh);
    EXPECT_EQ(simulatedSurface(mesh, network), mesh.triangles);
    network.restPositions.pop_back();
    network.vertexNodes[3] = 1;
    EXPECT_EQ(simulatedSurface(mesh, network), std::vector<Triangle>({{0, 1, 2}}));
    const Points drawn = drawnPositions(mesh, network, {{0, 0, 0}, {1, 0, 5}, {0, 1, 0}});
    EXPECT_EQ(drawn[3], Eigen::Vector3d(1, 1, 5));
}
