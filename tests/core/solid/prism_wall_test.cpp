#include "core/solid/prism_wall.h"

#include "core/geometry/adjacency.h"
#include "core/solid/self_intersections.h"
#include "core/support/errors.h"
#include "tests/support/solid_surfaces.h"
#include "tests/support/steady_progress.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <set>

namespace esm {
namespace {

using Eigen::Vector3d;
using testing::HasSubstr;

LatticeFilling wallOf(double thickness, int layers) {
    return {LatticeKind::Prisms, 0, thickness, layers};
}

std::set<Edge> tetrahedronEdges(const std::vector<Tetrahedron>& tetrahedra) {
    std::set<Edge> edges;
    for (const Tetrahedron& corners : tetrahedra)
        for (std::size_t i = 0; i < 4; ++i)
            for (std::size_t j = i + 1; j < 4; ++j)
                edges.insert(std::minmax(corners[i], corners[j]));
    return edges;
}

double wholeVolume(const PrismWall& wall) {
    double volume = 0;
    for (const Tetrahedron& tetrahedron : wall.tetrahedra)
        volume += volumeOf(tetrahedron, wall.nodes);
    return volume;
}

/// What every wall promises, whatever the surface.
void expectSoundWall(const TriangleMesh& mesh, const LatticeFilling& filling) {
    const PrismWall wall = prismWall(mesh, filling);
    const auto layers = static_cast<std::size_t>(filling.layers);
    ASSERT_EQ(wall.nodes.size(), mesh.vertices.size() * (layers + 1));
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i)
        EXPECT_EQ(wall.nodes[wall.vertexNodes[i]], mesh.vertices[i]);
    EXPECT_EQ(wall.tetrahedra.size(), 3 * layers * mesh.triangles.size());
    for (const Tetrahedron& tetrahedron : wall.tetrahedra)
        EXPECT_GT(volumeOf(tetrahedron, wall.nodes), 0);

    // Neighbours agree on the diagonals: no face is left over within the wall.
    const std::vector<Triangle> outer = outerTriangles(wall.tetrahedra);
    const std::size_t borders = countEdges(sidesByEdge(mesh.triangles)).boundary;
    EXPECT_EQ(outer.size(), 2 * mesh.triangles.size() + 2 * layers * borders);
    EXPECT_TRUE(countEdges(sidesByEdge(outer)).isClosed());
    EXPECT_EQ(selfIntersectionsOf({wall.nodes, outer, {}}).pairs, 0U);

    std::set<Edge> springs;
    for (const auto& [first, second, constant] : wall.springs) {
        EXPECT_TRUE(springs.insert({first, second}).second) << "a spring twice";
        EXPECT_GT(constant, 0);
    }
    EXPECT_EQ(springs, tetrahedronEdges(wall.tetrahedra));
    const Rigidity rigidity = rigidityOf(wall.nodes, wall.springs);
    EXPECT_EQ(rigidity.bodies, connectedParts(mesh.triangles, mesh.vertices.size()).count);
    EXPECT_EQ(rigidity.floppyModes, 0U);

    const LatticeEstimate estimate = estimateWall(mesh, filling);
    EXPECT_EQ(estimate.nodes, static_cast<double>(wall.nodes.size()));
    EXPECT_EQ(estimate.springs, static_cast<double>(wall.springs.size()));
    EXPECT_EQ(estimate.tetrahedra, static_cast<double>(wall.tetrahedra.size()));
}

TEST(PrismWall, IsSoundBeneathClosedAndOpenSurfacesOfSeveralParts) {
    TriangleMesh apart = test::ball(0.05, Vector3d(0.2, 0, 0), 12);
    test::append(apart, test::openTube(0.02, 0.1, 10, 12));
    for (const int layers : {1, 2, 3}) {
        expectSoundWall(lumpySurface(20, 40), wallOf(0.004, layers));
        expectSoundWall(test::torus(), wallOf(0.05, layers));
        expectSoundWall(flatSquare(0.1, 8), wallOf(0.005, layers));
        expectSoundWall(apart, wallOf(0.003, layers));
    }
}

TEST(PrismWall, HasTheVolumeOfItsAreaTimesItsThickness) {
    EXPECT_NEAR(wholeVolume(prismWall(flatSquare(0.1, 8), wallOf(0.005, 2))), 0.1 * 0.1 * 0.005, 1e-15);
    const TriangleMesh round = test::openTube(0.02, 0.1, 20, 40);
    const double middle = surfaceArea(round) * (0.02 - 0.001) / 0.02;
    EXPECT_NEAR(wholeVolume(prismWall(round, wallOf(0.002, 2))) / (middle * 0.002), 1, 0.01);
}

TEST(PrismWall, IsThinnerWhereTwoWallsMeetOrTheSurfaceBendsSharply) {
    const TriangleMesh thin = test::openTube(0.005, 0.1, 40, 12);
    const PrismWall wall = prismWall(thin, wallOf(0.006, 2));
    EXPECT_EQ(wall.shortened, thin.vertices.size());
    EXPECT_LT(wall.leastThickness, 0.005);
    expectSoundWall(thin, wallOf(0.006, 2));
    expectSoundWall(test::block({0, 0, 0}, {0.05, 0.05, 0.01}), wallOf(0.004, 1));
}

TEST(PrismWall, LeavesOutVerticesOfNoTriangle) {
    TriangleMesh mesh = flatSquare(0.1, 4);
    mesh.vertices.emplace_back(1, 1, 1);
    const PrismWall wall = prismWall(mesh, wallOf(0.005, 1));
    EXPECT_EQ(wall.nodes.size(), 2 * (mesh.vertices.size() - 1));
    EXPECT_EQ(wall.vertexNodes.back(), 0U);
}

TEST(PrismWall, TellsItsProgress) {
    test::expectGoodProgress([](const Progress& progress) {
        prismWall(test::ball(0.1, Vector3d::Zero(), 40), wallOf(0.003, 2), progress);
    });
}

std::string wallRefusal(const TriangleMesh& mesh, const LatticeFilling& filling) {
    try {
        prismWall(mesh, filling);
    } catch (const InvalidModel& error) {
        return error.what();
    }
    return "";
}

/// A sheet of which some vertices were pulled over their neighbours, so that triangles are folded over.
TriangleMesh foldedSheet(int folds) {
    constexpr int cells = 24;
    TriangleMesh mesh = flatSquare(0.12, cells);
    for (int fold = 0; fold < folds; ++fold)
        mesh.vertices[static_cast<std::size_t>((cells + 1) * (4 + 3 * fold) + 8)] +=
            Vector3d(0.0085, 0.001, 0.0005);
    return mesh;
}

TEST(PrismWall, LeavesOutAndCountsTrianglesThatCarryNoPrism) {
    for (const int layers : {1, 2}) {
        const TriangleMesh mesh = foldedSheet(1);
        const PrismWall wall = prismWall(mesh, wallOf(0.004, layers));
        for (const Tetrahedron& tetrahedron : wall.tetrahedra)
            EXPECT_GT(volumeOf(tetrahedron, wall.nodes), 0);
        const WallFit fit =
            wallFitOf(wall.nodes, {wallOf(0.004, layers), wall.tetrahedra, {}, {}}, mesh.triangles.size());
        EXPECT_GT(fit.leftOut, 0U);
        EXPECT_LE(50 * fit.leftOut, mesh.triangles.size());
        EXPECT_EQ(wall.tetrahedra.size(),
                  3 * static_cast<std::size_t>(layers) * (mesh.triangles.size() - fit.leftOut));
        EXPECT_EQ(wall.springs.size(),
                  static_cast<std::size_t>(estimateWall(mesh, wallOf(0.004, layers)).springs))
            << "their edges stay";
        EXPECT_EQ(fit.places, mesh.vertices.size());
        EXPECT_EQ(fit.thinner, wall.shortened);
        EXPECT_DOUBLE_EQ(fit.least, wall.leastThickness);
        EXPECT_FALSE(isOftenThinner(fit));
        std::set<std::uint32_t> inTetrahedra;
        for (const Tetrahedron& tetrahedron : wall.tetrahedra)
            inTetrahedra.insert(tetrahedron.begin(), tetrahedron.end());
        EXPECT_EQ(inTetrahedra.size(), wall.nodes.size()) << "no node is left bare";
    }
    EXPECT_THAT(wallRefusal(foldedSheet(6), wallOf(0.004, 1)), HasSubstr("no wall fits under"));
}

TEST(PrismWall, RefusesWhatHasNone) {
    const TriangleMesh mesh = lumpySurface(20, 40);
    for (const double thickness : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()})
        EXPECT_THAT(wallRefusal(mesh, wallOf(thickness, 1)),
                    HasSubstr("the thickness of the wall must be above 0 m"));
    EXPECT_THAT(wallRefusal(mesh, wallOf(0.001, 0)), HasSubstr("the number of layers must be from 1 to 8"));
    EXPECT_THAT(wallRefusal(mesh, wallOf(1, 1)), HasSubstr("a wall of 1000 mm is too thick"));
    EXPECT_THAT(wallRefusal({}, wallOf(0.001, 1)), HasSubstr("there is no surface"));
    TriangleMesh branching = flatSquare(0.1, 2);
    branching.vertices.emplace_back(0, 0, 0.1);
    branching.triangles.push_back({branching.triangles[0][0], branching.triangles[0][2], 9});
    EXPECT_THAT(wallRefusal(branching, wallOf(0.001, 1)), HasSubstr("the surface branches: at 1 edges"));
}

TEST(PrismWall, MayHaveAsManyLayersAsKeepPrismsLow) {
    EXPECT_EQ(usualLayers(flatSquare(0.1, 10), 0.001), 2);
    EXPECT_EQ(usualLayers(flatSquare(0.1, 10), 0.03), 4);
    EXPECT_EQ(usualLayers(flatSquare(0.1, 10), 1), mostWallLayers);
}

} // namespace
} // namespace esm
