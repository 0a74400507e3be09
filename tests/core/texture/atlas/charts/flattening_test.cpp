#include "core/texture/atlas/charts/flattening.h"

#include "core/texture/atlas/charts/dual_graph.h"
#include "core/texture/atlas/stretch.h"
#include "tests/support/test_surfaces.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace esm {
namespace {

ChartMesh wholeAsChart(const TriangleMesh& mesh) {
    std::vector<std::uint32_t> all(mesh.triangles.size());
    std::iota(all.begin(), all.end(), 0U);
    const DualGraph graph = dualGraph(mesh, std::vector<bool>(all.size(), true));
    return chartMesh(mesh, graph.across, all);
}

/// A flat square whose points are moved.
template<typename Move> TriangleMesh bent(int cells, const Move& move) {
    TriangleMesh mesh = flatSquare(2, cells);
    for (Eigen::Vector3d& point : mesh.vertices)
        point = move(point.x(), point.y());
    return mesh;
}

std::vector<Stretch> stretchesOf(const ChartMesh& chart, const PlanePoints& places) {
    std::vector<Stretch> stretches;
    for (const Triangle& at : chart.corners)
        stretches.push_back(stretchOf({chart.vertices[at[0]], chart.vertices[at[1]], chart.vertices[at[2]]},
                                      {places[at[0]], places[at[1]], places[at[2]]}));
    return stretches;
}

TEST(Flattening, LaysWhatCanBeUnrolledWithoutAnyStretch) {
    const TriangleMesh rolled =
        bent(12, [](double x, double y) { return Eigen::Vector3d(std::sin(1.4 * x), y, std::cos(1.4 * x)); });
    for (const TriangleMesh& mesh : {flatSquare(0.1, 7), flatSquare(0.1, 1), rolled}) {
        const ChartMesh chart = wholeAsChart(mesh);
        ASSERT_TRUE(chart.isDisc);
        const auto places = flattened(chart);
        ASSERT_TRUE(places);
        for (const Stretch& stretch : stretchesOf(chart, *places)) {
            EXPECT_NEAR(stretch.larger, 1, 1e-3);
            EXPECT_NEAR(stretch.smaller, 1, 1e-3);
            EXPECT_FALSE(stretch.isClockwise);
        }
    }
}

TEST(Flattening, SharesOutTheStretchOfACap) {
    // Turned by 60° at the middles of its sides. Laid by distance from the middle, a cap would be stretched
    // by 60° / sin 60° there.
    const TriangleMesh cap = bent(24, [](double x, double y) {
        const double turn = M_PI / 3 * std::hypot(x, y), around = std::atan2(y, x);
        return Eigen::Vector3d(std::sin(turn) * std::cos(around), std::sin(turn) * std::sin(around),
                               std::cos(turn));
    });
    const ChartMesh chart = wholeAsChart(cap);
    const auto places = flattened(chart);
    ASSERT_TRUE(places);
    const std::vector<Stretch> stretches = stretchesOf(chart, *places);
    for (const Stretch& stretch : stretches)
        ASSERT_TRUE(stretch.larger > 0 && !stretch.isClockwise);
    EXPECT_LT(angleSpread(stretches).mean, 1.15);
    EXPECT_LT(angleSpread(stretches).percentile95, 1.5);
    EXPECT_LT(areaSpread(stretches).percentile95, 1.3);
}

TEST(Flattening, KnowsWhatIsADisc) {
    EXPECT_FALSE(wholeAsChart(lumpySurface(6, 8)).isDisc) << "closed";
    TriangleMesh ring = flatSquare(0.1, 3);
    ring.triangles.erase(ring.triangles.begin() + 8, ring.triangles.begin() + 10);
    EXPECT_FALSE(wholeAsChart(ring).isDisc);
    TriangleMesh corner = flatSquare(0.1, 3);
    corner.triangles.erase(corner.triangles.begin(), corner.triangles.begin() + 2);
    EXPECT_TRUE(wholeAsChart(corner).isDisc);
}

TEST(Flattening, TakesAVertexApartThatOnlyTouches) {
    // Two squares that meet at a corner, joined the long way around: the border would meet itself there.
    TriangleMesh mesh = flatSquare(0.1, 3);
    const std::vector<Triangle> all = mesh.triangles;
    mesh.triangles.clear();
    for (const std::size_t cell : {0U, 1U, 2U, 3U, 5U, 6U, 7U}) // not the middle, nor the upper right
        for (std::size_t i = 0; i < 2; ++i)
            mesh.triangles.push_back(all[2 * cell + i]);
    const ChartMesh open = wholeAsChart(mesh);
    EXPECT_TRUE(open.isDisc);
    EXPECT_EQ(open.vertices.size(), 16U) << "15 of the cells, and the one that only touches twice";
}

} // namespace
} // namespace esm
