#include "core/model/net_elasticity.h"

#include "core/exchange/meshes/mesh_file.h"
#include "core/geometry/adjacency.h"
#include "core/geometry/repair.h"
#include "core/surface/simplify.h"
#include "tests/support/flat_nets.h"
#include "tests/support/flat_patch.h"
#include "tests/support/rounds.h"
#include "tests/support/shared_data.h"
#include "tests/support/test_surfaces.h"
#include "tests/support/virtual_pull.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>

namespace esm {
namespace {

using test::flatNet;
using test::jittered;
using test::Judged;
using test::regularNet;
using test::regularNetOf;

std::vector<double> factorsOf(const TriangleMesh& mesh) {
    const SpringNetwork network = networkFromMesh(mesh);
    return netFactors(network.restPositions, network.springs, mesh.triangles);
}

Judged judgedWith(const TriangleMesh& mesh, const std::vector<double>& factors) {
    return test::judged(flatNet(mesh, factors), test::isAtBorder(mesh),
                        nodeAreas(mesh.vertices, mesh.triangles), isLongRun() ? 400 : 60);
}

/// One constant for all springs, half of it at the border.
std::vector<double> plainFactors(const TriangleMesh& mesh) {
    std::map<Edge, double> ofEdge;
    forEachEdge(sidesByEdge(mesh.triangles),
                [&](auto first, auto last) { ofEdge[first->edge] = last - first == 1 ? 0.5 : 1; });
    std::vector<double> factors;
    for (const Spring& spring : networkFromMesh(mesh).springs)
        factors.push_back(ofEdge.at(std::minmax({spring.first, spring.second})));
    return factors;
}

void expectSheet(const TriangleMesh& mesh, double whole, double patches) {
    const Judged judged = judgedWith(mesh, factorsOf(mesh));
    EXPECT_GT(judged.whole.least, 1 - whole);
    EXPECT_LT(judged.whole.most, 1 + whole);
    EXPECT_GT(judged.patches.least, 1 - patches);
    EXPECT_LT(judged.patches.most, 1 + patches);
}

std::vector<std::size_t> sizes() {
    return isLongRun() ? std::vector<std::size_t>{500, 5000, 50000} : std::vector<std::size_t>{500, 3000};
}

TEST(NetElasticity, OfTheRegularNetIsItsConstantAtEverySize) {
    for (const std::size_t size : sizes()) {
        const TriangleMesh mesh = regularNetOf(size);
        const std::vector<double> factors = factorsOf(mesh), plain = plainFactors(mesh);
        for (std::size_t i = 0; i < factors.size(); ++i)
            ASSERT_NEAR(factors[i], plain[i], 1e-9);
        EXPECT_NEAR(test::pulledModulus(flatNet(mesh, factors), surfaceArea(mesh), 0.75), 1, 1e-6);
        expectSheet(mesh, 1e-6, 1e-6);
    }
}

TEST(NetElasticity, OfJitteredNetsIsThatOfTheSheet) {
    for (const std::size_t size : sizes()) {
        const TriangleMesh mesh = jittered(regularNetOf(size), 0.4, seedOf(0));
        SCOPED_TRACE(std::to_string(size) + " nodes, seed " + std::to_string(seedOf(0)));
        expectSheet(mesh, 0.03, 0.08);
        EXPECT_NEAR(test::pulledModulus(flatNet(mesh, factorsOf(mesh)), surfaceArea(mesh), 0.75), 1, 0.03);
        // What it is for: with equal constants the net is a fifth too soft.
        EXPECT_LT(judgedWith(mesh, plainFactors(mesh)).whole.most, 0.88);
    }
}

TEST(NetElasticity, OfGradedNetsIsThatOfTheSheet) {
    for (const std::size_t size : sizes()) {
        SCOPED_TRACE(std::to_string(size) + " nodes, seed " + std::to_string(seedOf(0)));
        expectSheet(test::graded(regularNetOf(size), 10), 0.005, 0.02);
        expectSheet(test::graded(jittered(regularNetOf(size), 0.3, seedOf(0)), 10), 0.03, 0.08);
    }
}

// A sheet of which vertices were left out at will is the most uneven of nets: there patches differ by more
// than the 8 % that are asked for, but not the whole.
TEST(NetElasticity, OfRemeshedSheetsIsThatOfTheSheetAsAWhole) {
    for (const std::size_t size : sizes()) {
        const TriangleMesh finer = jittered(regularNetOf(4 * size), 0.3, seedOf(0));
        const SimplifiedMesh simplified = simplify(finer, size);
        TriangleMesh mesh{{}, simplified.triangles};
        for (const std::uint32_t vertex : simplified.vertices)
            mesh.vertices.push_back(finer.vertices[vertex]);
        SCOPED_TRACE(std::to_string(size) + " nodes, seed " + std::to_string(seedOf(0)));
        expectSheet(mesh, 0.08, 0.35);
        const Judged plain = judgedWith(mesh, plainFactors(mesh));
        EXPECT_LT(plain.whole.least, 0.8);
        EXPECT_LT(plain.patches.least, 0.65);
    }
}

// Three directions of springs a node cannot make a sheet when none of them runs across the triangles' long
// side; their mean over all directions can be right.
TEST(NetElasticity, OfDrawnOutNetsIsNearestInTheMean) {
    for (const double ratio : {1.2, 1.5, 2.0}) {
        const TriangleMesh mesh = test::drawnOut(jittered(regularNetOf(1000), 0.3, seedOf(0)), ratio);
        const Judged ours = judgedWith(mesh, factorsOf(mesh)), plain = judgedWith(mesh, plainFactors(mesh));
        EXPECT_LT(ours.whole.most / ours.whole.least, 0.75 * plain.whole.most / plain.whole.least) << ratio;
        EXPECT_NEAR(ours.whole.most + ours.whole.least, 2, 0.25) << ratio;
    }
}

TEST(NetElasticity, KnowsNoSizeNoPlaceAndNoOrder) {
    const TriangleMesh mesh = jittered(regularNetOf(400), 0.4, seedOf(0));
    const SpringNetwork network = networkFromMesh(mesh);
    const std::vector<double> factors = factorsOf(mesh);
    const Eigen::Isometry3d placed =
        Eigen::Translation3d(0.1, -0.2, 0.3) * Eigen::AngleAxisd(2, Eigen::Vector3d(1, 2, -1).normalized());
    std::vector<Eigen::Vector3d> nodes;
    for (const Eigen::Vector3d& vertex : mesh.vertices)
        nodes.push_back(placed * (0.003 * vertex));
    std::vector<Spring> springs = network.springs;
    std::reverse(springs.begin(), springs.end());
    for (std::size_t i = 0; i < springs.size(); i += 2)
        std::swap(springs[i].first, springs[i].second);
    std::vector<Triangle> triangles = mesh.triangles;
    std::rotate(triangles.begin(), triangles.begin() + 50, triangles.end());
    for (std::size_t i = 0; i < triangles.size(); i += 3)
        std::rotate(triangles[i].begin(), triangles[i].begin() + 1, triangles[i].end());
    std::vector<double> others = netFactors(nodes, springs, triangles);
    std::reverse(others.begin(), others.end());
    for (std::size_t i = 0; i < factors.size(); ++i)
        ASSERT_NEAR(others[i], factors[i], 1e-9 * factors[i]);
}

// Unrolled, a tube of triangles is the regular net. It stays so when it is rolled up.
TEST(NetElasticity, OfARolledNetIsThatOfTheFlatOne) {
    constexpr std::uint32_t around = 24, along = 30;
    TriangleMesh tube = regularNet(around, along);
    const double radius = around / (2 * M_PI);
    for (Eigen::Vector3d& vertex : tube.vertices)
        vertex = {radius * std::cos(vertex.x() / radius), radius * std::sin(vertex.x() / radius), vertex.y()};
    for (Triangle& triangle : tube.triangles) // closed along the seam
        for (std::uint32_t& vertex : triangle)
            if (vertex % (around + 1) == around) vertex -= around;
    const std::vector<double> factors = factorsOf(tube);
    const std::vector<Spring> springs = networkFromMesh(tube).springs;
    const std::vector<bool> isAtBorder = test::isAtBorder(tube);
    for (std::size_t i = 0; i < factors.size(); ++i)
        EXPECT_NEAR(factors[i], isAtBorder[springs[i].first] && isAtBorder[springs[i].second] ? 0.5 : 1,
                    0.02);
}

TEST(NetElasticity, CountsEverySheetWhereSheetsMeet) {
    TriangleMesh mesh = regularNet(12, 12);
    const auto sheet = static_cast<std::uint32_t>(mesh.vertices.size());
    const std::vector<Triangle> triangles = mesh.triangles;
    for (const double angle : {2 * M_PI / 3, 4 * M_PI / 3}) { // two more, around the x axis
        const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
        for (std::uint32_t i = 0; i < sheet; ++i)
            mesh.vertices.emplace_back(Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitX()) * mesh.vertices[i]);
        for (const Triangle& t : triangles) {
            Triangle turned;
            for (std::size_t i = 0; i < 3; ++i)
                turned[i] = t[i] < 13 ? t[i] : first + t[i];
            mesh.triangles.push_back(turned);
        }
    }
    const std::vector<double> factors = factorsOf(mesh);
    const std::vector<Spring> springs = networkFromMesh(mesh).springs;
    for (std::size_t i = 0; i < factors.size(); ++i)
        if (springs[i].first < 13 && springs[i].second < 13) {
            EXPECT_NEAR(factors[i], 1.5, 0.02);
        }
}

TEST(NetElasticity, LeavesSpringsAloneThatRunAlongNoTriangle) {
    const TriangleMesh mesh = regularNet(8, 8);
    std::vector<Spring> springs{{0, 40, 1}};
    for (const Spring& spring : networkFromMesh(mesh).springs)
        springs.push_back(spring);
    const std::vector<double> factors = netFactors(mesh.vertices, springs, mesh.triangles);
    EXPECT_EQ(factors[0], 1);
    EXPECT_EQ(std::vector<double>(factors.begin() + 1, factors.end()), factorsOf(mesh));
    EXPECT_EQ(netFactors(mesh.vertices, springs, {}), std::vector<double>(springs.size(), 1.0));
}

TEST(NetElasticity, StaysWithinBoundsOnTrianglesOfNoArea) {
    TriangleMesh mesh = regularNet(10, 10);
    mesh.vertices[60] = mesh.vertices[61];
    mesh.vertices[40] = (mesh.vertices[39] + mesh.vertices[51]) / 2;
    for (Eigen::Vector3d& vertex : mesh.vertices)
        if (vertex.x() > 6) vertex.x() = 6;
    for (const double factor : factorsOf(mesh)) {
        EXPECT_GE(factor, 0.05);
        EXPECT_LE(factor, 10);
    }
}

TEST(NetElasticity, NodesShareTheWholeArea) {
    const TriangleMesh mesh = lumpySurface(20, 30);
    const std::vector<double> areas = nodeAreas(mesh.vertices, mesh.triangles);
    EXPECT_NEAR(std::accumulate(areas.begin(), areas.end(), 0.0), surfaceArea(mesh), 1e-12);
    const TriangleMesh regular = regularNet(6, 6);
    EXPECT_NEAR(nodeAreas(regular.vertices, regular.triangles)[24], std::sqrt(0.75), 1e-12);
}

/// Each stretch of each piece of an organ that can be laid flat, over the sheet's.
std::vector<double> judgedPieces(const TriangleMesh& mesh, const std::vector<double>& factors) {
    std::map<Edge, double> ofEdge;
    const std::vector<Spring> springs = networkFromMesh(mesh).springs;
    for (std::size_t i = 0; i < springs.size(); ++i)
        ofEdge[std::minmax({springs[i].first, springs[i].second})] = factors[i];
    const auto at = test::trianglesAt(mesh);
    std::vector<double> ratios;
    for (std::uint32_t middle = 0; middle < mesh.vertices.size(); middle += 97) {
        const auto patch = test::flatPatch(mesh, at, middle, 200);
        if (!patch || patch->stretch > 0.02) continue;
        std::vector<double> constants;
        for (const Spring& spring : networkFromMesh(patch->mesh).springs)
            constants.push_back(
                ofEdge.at(std::minmax({patch->vertices[spring.first], patch->vertices[spring.second]})));
        const std::vector<bool> isAtBorder = test::isAtBorder(patch->mesh);
        if (std::find(isAtBorder.begin(), isAtBorder.begin() + 100, true) != isAtBorder.begin() + 100)
            continue;
        const std::vector<double> areas = nodeAreas(patch->mesh.vertices, patch->mesh.triangles);
        const double area = std::accumulate(areas.begin(), areas.begin() + 100, 0.0);
        for (const double angle : {0.0, M_PI / 4, M_PI / 2, 3 * M_PI / 4}) {
            const Eigen::Vector2d along(std::cos(angle), std::sin(angle));
            const Eigen::Matrix2d strain = along * along.transpose();
            const auto energies = test::strainedEnergies(flatNet(patch->mesh, constants), isAtBorder, strain);
            const double energy = std::accumulate(energies.begin(), energies.begin() + 100, 0.0);
            ratios.push_back(energy / area / test::sheetEnergy(strain));
        }
    }
    std::sort(ratios.begin(), ratios.end());
    return ratios;
}

TEST(NetElasticity, OfALiverIsThatOfTheSheetPieceByPiece) {
    const auto file = sharedData("meshes/sks-liver-H07.ply");
    ESM_SKIP_WITHOUT(file);
    const TriangleMesh mesh = repair(readMeshFile(file)).mesh;
    const std::vector<double> ours = judgedPieces(mesh, factorsOf(mesh));
    ASSERT_GT(ours.size(), 100U);
    EXPECT_GT(ours[ours.size() / 20], 0.92);
    EXPECT_LT(ours[ours.size() * 19 / 20], 1.08);
    EXPECT_NEAR(std::accumulate(ours.begin(), ours.end(), 0.0) / static_cast<double>(ours.size()), 1, 0.02);
    const std::vector<double> plain = judgedPieces(mesh, plainFactors(mesh));
    EXPECT_GT(plain[plain.size() * 19 / 20], 1.15);
}

} // namespace
} // namespace esm
