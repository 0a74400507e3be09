#include "core/texture/atlas/charts/surface_charts.h"

#include "core/texture/atlas/atlas.h"
#include "core/texture/atlas/distortion.h"
#include "tests/support/test_surfaces.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace esm {
namespace {

constexpr AtlasOptions inCharts{1024, 1, 2, AtlasLayout::Charts};

/// A bent tube, open at its ends.
TriangleMesh tube(int rings, int segments) {
    TriangleMesh mesh;
    for (int ring = 0; ring <= rings; ++ring)
        for (int segment = 0; segment < segments; ++segment) {
            const double along = 3.0 * ring / rings, around = 2 * M_PI * segment / segments;
            const double reach = 0.1 + 0.02 * std::cos(around);
            mesh.vertices.emplace_back(reach * std::cos(along), reach * std::sin(along),
                                       0.02 * std::sin(around) + 0.02 * along);
        }
    const auto index = [&](int ring, int segment) {
        return static_cast<std::uint32_t>(ring * segments + segment % segments);
    };
    for (int ring = 0; ring < rings; ++ring)
        for (int segment = 0; segment < segments; ++segment) {
            const std::uint32_t a = index(ring, segment), b = index(ring, segment + 1),
                                c = index(ring + 1, segment + 1), d = index(ring + 1, segment);
            mesh.triangles.push_back({a, b, c});
            mesh.triangles.push_back({a, c, d});
        }
    return mesh;
}

/// Both in one surface, apart.
TriangleMesh together(TriangleMesh one, const TriangleMesh& other) {
    const auto first = static_cast<std::uint32_t>(one.vertices.size());
    for (const Eigen::Vector3d& point : other.vertices)
        one.vertices.push_back(point + Eigen::Vector3d(1, 0, 0));
    for (const Triangle& triangle : other.triangles)
        one.triangles.push_back({triangle[0] + first, triangle[1] + first, triangle[2] + first});
    return one;
}

/// Middles of texels that more than one triangle covers: each triangle asked by itself whether it is there.
std::size_t coveredTwice(const Atlas& atlas) {
    const int size = atlas.options.size;
    std::vector<char> covered(static_cast<std::size_t>(size) * static_cast<std::size_t>(size), 0);
    std::size_t again = 0;
    for (const auto& corners : atlas.corners) {
        Eigen::AlignedBox2d box;
        for (const Eigen::Vector2d& corner : corners)
            box.extend(corner);
        for (int y = static_cast<int>(box.min().y()); y <= static_cast<int>(box.max().y()); ++y)
            for (int x = static_cast<int>(box.min().x()); x <= static_cast<int>(box.max().x()); ++x) {
                const Eigen::Vector2d middle(x + 0.5, y + 0.5);
                std::array<double, 3> sides{};
                for (std::size_t i = 0; i < 3; ++i) {
                    const Eigen::Vector2d side = corners[(i + 1) % 3] - corners[i], to = middle - corners[i];
                    sides[i] = side.x() * to.y() - side.y() * to.x();
                }
                const auto [least, most] = std::minmax({sides[0], sides[1], sides[2]});
                if (!(least > 1e-9 || most < -1e-9)) continue;
                char& texel = covered[static_cast<std::size_t>(y * size + x)];
                again += texel != 0;
                texel = 1;
            }
    }
    return again;
}

/// Each chart keeps its limits, and all have one density: so does the whole.
void expectWithin(const DistortionSpread& spread, const DistortionSpread& limit) {
    constexpr double rounding = 1e-6;
    EXPECT_LE(spread.mean, limit.mean + rounding);
    EXPECT_LE(spread.percentile95, limit.percentile95 + rounding);
    EXPECT_LE(spread.worst, limit.worst + rounding);
}

TEST(SurfaceCharts, DistortWithinTheirLimitsAndOverlapNowhere) {
    for (const TriangleMesh& mesh :
         {lumpySurface(40, 60), tube(60, 24), together(tube(30, 16), lumpySurface(20, 30))}) {
        const Atlas atlas = packAtlas(mesh, inCharts);
        const Distortion distortion = distortionOf(mesh, atlas);
        expectWithin(distortion.angle, chartAngleLimit);
        expectWithin(distortion.area, chartAreaLimit);
        EXPECT_EQ(distortion.flipped + distortion.collapsed, 0U);
        EXPECT_EQ(coveredTwice(atlas), 0U);
    }
}

TEST(SurfaceCharts, HaveFewerSeamsThanUnfoldedGroups) {
    AtlasOptions unfolded = inCharts;
    unfolded.layout = AtlasLayout::UnfoldedGroups;
    for (const TriangleMesh& mesh : {lumpySurface(40, 60), tube(60, 24), flatSquare(0.1, 30)}) {
        const Atlas atlas = packAtlas(mesh, inCharts);
        EXPECT_LT(seamShare(mesh, atlas), 0.5 * seamShare(mesh, packAtlas(mesh, unfolded)));
        EXPECT_GT(atlas.utilisation, 0.5);
    }
}

TEST(SurfaceCharts, KeepDensityTheSameFromChartToChart) {
    const TriangleMesh mesh = lumpySurface(40, 60);
    const Atlas atlas = packAtlas(mesh, inCharts);
    const std::vector<std::uint32_t> patches = patchNumbers(mesh, atlas);
    std::map<std::uint32_t, std::array<double, 2>> areas;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const auto& at = atlas.corners[i];
        areas[patches[i]][0] += areaNormal(mesh.vertices, mesh.triangles[i]).norm();
        areas[patches[i]][1] +=
            std::abs((at[1] - at[0]).x() * (at[2] - at[0]).y() - (at[1] - at[0]).y() * (at[2] - at[0]).x());
    }
    EXPECT_GT(areas.size(), 3U);
    for (const auto& [patch, area] : areas)
        EXPECT_NEAR(std::sqrt(area[1] / area[0]) / atlas.texelsPerMetre, 1, 1e-9);
}

TEST(SurfaceCharts, AreCutWhereTheyDoNotFitThePages) {
    const TriangleMesh mesh = lumpySurface(40, 60);
    AtlasOptions options = inCharts;
    options.size = 128;
    options.texelsPerMetre = 2000; // the organ is 400 texels long
    const Atlas atlas = packAtlas(mesh, options);
    EXPECT_GT(atlas.options.pages, 10);
    EXPECT_EQ(distortionOf(mesh, atlas).flipped, 0U);
}

TEST(SurfaceCharts, AreTheSameOnAnyNumberOfThreads) {
    const TriangleMesh mesh = lumpySurface(40, 60);
    const Atlas atlas = packAtlas(mesh, inCharts);
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    EXPECT_EQ(packAtlas(mesh, inCharts).corners, atlas.corners);
}

TEST(SurfaceCharts, OfATriangleAloneKeepItsShape) {
    const TriangleMesh mesh{{{0, 0, 0}, {0.3, 0, 0}, {0, 0, 0.4}}, {{0, 1, 2}}};
    const Atlas atlas = packAtlas(mesh, inCharts);
    EXPECT_NEAR(distortionOf(mesh, atlas).angle.worst, 1, 1e-9);
    EXPECT_NEAR((atlas.corners[0][2] - atlas.corners[0][1]).norm(), 0.5 * atlas.texelsPerMetre, 1e-9);
}

} // namespace
} // namespace esm
