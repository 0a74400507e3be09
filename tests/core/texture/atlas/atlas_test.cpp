#include "core/texture/atlas/atlas.h"

#include "core/support/errors.h"
#include "core/texture/atlas/distortion.h"
#include "tests/support/test_surfaces.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>

using namespace esm;
using testing::HasSubstr;
using Patch = std::array<Eigen::Vector2d, 3>;

namespace {

double signedArea(const Patch& patch) {
    const Eigen::Vector2d u = patch[1] - patch[0], v = patch[2] - patch[0];
    return (u.x() * v.y() - u.y() * v.x()) / 2;
}

double distanceToSegment(const Eigen::Vector2d& point, const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    const Eigen::Vector2d along = b - a;
    const double square = along.squaredNorm();
    const double t = square > 0 ? std::clamp((point - a).dot(along) / square, 0.0, 1.0) : 0;
    return (point - a - t * along).norm();
}

bool isSeparatedAlong(const Eigen::Vector2d& normal, const Patch& a, const Patch& b) {
    const auto [lowA, highA] = std::minmax({normal.dot(a[0]), normal.dot(a[1]), normal.dot(a[2])});
    const auto [lowB, highB] = std::minmax({normal.dot(b[0]), normal.dot(b[1]), normal.dot(b[2])});
    return highA < lowB || highB < lowA;
}

/// True when a line along one side of either patch, or along an axis, has them on different sides.
bool areSeparated(const Patch& a, const Patch& b) {
    for (const Patch* patch : {&a, &b}) {
        for (std::size_t i = 0; i < 3; ++i) {
            const Eigen::Vector2d side = (*patch)[(i + 1) % 3] - (*patch)[i];
            if (isSeparatedAlong({-side.y(), side.x()}, a, b)) return true;
        }
    }
    return isSeparatedAlong({1, 0}, a, b) || isSeparatedAlong({0, 1}, a, b);
}

/// Exact distance of two patches, 0 when they overlap; knows nothing of how they were laid out.
double patchDistance(const Patch& a, const Patch& b) {
    if (!areSeparated(a, b)) return 0;
    double distance = 1e300;
    for (std::size_t corner = 0; corner < 3; ++corner) {
        for (std::size_t side = 0; side < 3; ++side) {
            distance = std::min(distance, distanceToSegment(a[corner], b[side], b[(side + 1) % 3]));
            distance = std::min(distance, distanceToSegment(b[corner], a[side], a[(side + 1) % 3]));
        }
    }
    return distance;
}

/// Whether two triangles have a corner in common, on the surface and in the texture.
bool touch(const TriangleMesh& mesh, const Atlas& atlas, std::size_t a, std::size_t b) {
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
            if (mesh.triangles[a][i] == mesh.triangles[b][j] && atlas.corners[a][i] == atlas.corners[b][j])
                return true;
    return false;
}

/// Without a millionth of its size along its sides.
Patch shrunk(const Patch& patch) {
    const Eigen::Vector2d middle = (patch[0] + patch[1] + patch[2]) / 3;
    Patch result;
    for (std::size_t i = 0; i < 3; ++i)
        result[i] = middle + (1 - 1e-6) * (patch[i] - middle);
    return result;
}

/// The smallest distance of any two triangles on one page that do not touch, 1000 when all are farther than
/// the gap's neighbourhood; 0 where some overlap. In charts, where triangles may be smaller than the gap, of
/// two in different ones.
double smallestDistance(const TriangleMesh& mesh, const Atlas& atlas) {
    constexpr double cellSize = 32;
    std::map<std::array<int, 3>, std::vector<std::size_t>> cells;
    const double reach = atlas.options.gap + 1.0;
    const bool areCharts = atlas.options.layout == AtlasLayout::Charts;
    const std::vector<std::uint32_t> patches = patchNumbers(mesh, atlas);
    double smallest = 1000;
    for (std::size_t i = 0; i < atlas.corners.size(); ++i) {
        Eigen::AlignedBox2d box;
        for (const Eigen::Vector2d& corner : atlas.corners[i])
            box.extend(corner);
        const Eigen::Vector2i low = ((box.min().array() - reach) / cellSize).floor().cast<int>();
        const Eigen::Vector2i high = ((box.max().array() + reach) / cellSize).floor().cast<int>();
        for (int y = low.y(); y <= high.y(); ++y) {
            for (int x = low.x(); x <= high.x(); ++x) {
                std::vector<std::size_t>& cell = cells[{atlas.page[i], x, y}];
                for (const std::size_t other : cell) {
                    const Patch &a = atlas.corners[i], &b = atlas.corners[other];
                    const bool areOne = areCharts && patches[i] == patches[other];
                    if (!areOne && !touch(mesh, atlas, i, other))
                        smallest = std::min(smallest, patchDistance(a, b));
                    else if (!areSeparated(shrunk(a), shrunk(b)))
                        return 0;
                }
                if (cell.empty() || cell.back() != i) cell.push_back(i);
            }
        }
    }
    return smallest;
}

/// The largest deviation of a patch's sides from those of its triangle, texels.
double largestDeviation(const TriangleMesh& mesh, const Atlas& atlas) {
    double largest = 0;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const std::size_t next = (corner + 1) % 3;
            const double real =
                (mesh.vertices[mesh.triangles[i][next]] - mesh.vertices[mesh.triangles[i][corner]]).norm();
            const double laid = (atlas.corners[i][next] - atlas.corners[i][corner]).norm();
            largest = std::max(largest, std::abs(laid - atlas.texelsPerMetre * real));
        }
    }
    return largest;
}

void expectWithinPages(const Atlas& atlas) {
    const double border = atlas.options.gap / 2.0 - 1e-9, end = atlas.options.size - border;
    for (std::size_t i = 0; i < atlas.corners.size(); ++i) {
        ASSERT_LT(atlas.page[i], atlas.options.pages);
        for (const Eigen::Vector2d& corner : atlas.corners[i])
            ASSERT_TRUE(corner.minCoeff() >= border && corner.maxCoeff() <= end) << corner.transpose();
    }
}

std::string refusal(const TriangleMesh& mesh, const AtlasOptions& options) {
    try {
        packAtlas(mesh, options);
    } catch (const InvalidModel& error) {
        return error.what();
    }
    return {};
}

/// Triangles without any order, from needles to equilateral ones, sizes over three orders of magnitude.
TriangleMesh randomTriangles(int count) {
    std::mt19937 random(7);
    std::normal_distribution<double> spread;
    TriangleMesh mesh;
    for (int i = 0; i < count; ++i) {
        const double size = 0.01 * std::exp(1.2 * spread(random));
        for (int corner = 0; corner < 3; ++corner)
            mesh.vertices.push_back(size *
                                    Eigen::Vector3d(spread(random), spread(random), 0.1 * spread(random)));
        const auto first = static_cast<std::uint32_t>(3 * i);
        mesh.triangles.push_back({first, first + 1, first + 2});
    }
    return mesh;
}

} // namespace

struct AtlasCase {
    const char* name;
    TriangleMesh mesh;
    AtlasOptions options;
};

class AtlasOf : public testing::TestWithParam<AtlasCase> {};

TEST_P(AtlasOf, KeepsTheGapBetweenAllPatches) {
    const AtlasCase& given = GetParam();
    const Atlas atlas = packAtlas(given.mesh, given.options);
    ASSERT_EQ(atlas.corners.size(), given.mesh.triangles.size());
    ASSERT_EQ(atlas.page.size(), given.mesh.triangles.size());
    expectWithinPages(atlas);
    EXPECT_GE(smallestDistance(given.mesh, atlas), given.options.gap - 1e-6);
    double area = 0;
    for (const Patch& patch : atlas.corners) {
        if (given.options.layout == AtlasLayout::Rows) {
            EXPECT_LE(signedArea(patch), 0) << "mirrored";
        }
        area += std::abs(signedArea(patch));
    }
    const double pages = double(given.options.size) * given.options.size * given.options.pages;
    EXPECT_NEAR(atlas.utilisation, area / pages, 1e-9);
}

TEST_P(AtlasOf, KeepsShapesUnlessItStretches) {
    const AtlasCase& given = GetParam();
    const Atlas atlas = packAtlas(given.mesh, given.options);
    if (!isStretched(given.options.layout)) {
        EXPECT_LT(largestDeviation(given.mesh, atlas), 1e-3);
    }
    const Distortion distortion = distortionOf(given.mesh, atlas);
    EXPECT_EQ(distortion.flipped + distortion.collapsed, 0U);
    EXPECT_LT(distortion.angle.mean, 1.15);
    EXPECT_LT(distortion.angle.percentile95, 1.6);
    EXPECT_LT(distortion.area.percentile95, 1.5);
}

namespace {

std::vector<AtlasCase> atlasCases() {
    std::vector<AtlasCase> cases;
    for (const AtlasLayout layout : atlasLayouts) {
        const auto add = [&](const char* name, TriangleMesh mesh, AtlasOptions options) {
            options.layout = layout;
            cases.push_back({name, std::move(mesh), options});
        };
        add("Lumpy", lumpySurface(30, 40), {512, 1, 2});
        add("LumpyOnThreePages", lumpySurface(30, 40), {256, 3, 3});
        add("LumpyWithoutGap", lumpySurface(30, 40), {512, 1, 0});
        add("LumpyWithAWideGap", lumpySurface(20, 20), {1024, 1, 9});
        add("ManyTriangles", lumpySurface(100, 100), {2048, 1, 2});
        add("EqualTriangles", flatSquare(0.1, 20), {512, 1, 2});
        add("OneTriangle", {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}}, {64, 1, 2});
        add("Random", randomTriangles(600), {1024, 1, 2});
        add("RandomOnPages", randomTriangles(600), {512, 4, 5});
    }
    return cases;
}

/// What no layout of single triangles can exceed: each grown by half the gap on all sides, the pages full.
double mostUse(const TriangleMesh& mesh, const AtlasOptions& options) {
    double sides = 0;
    for (const Triangle& triangle : mesh.triangles)
        for (std::size_t corner = 0; corner < 3; ++corner)
            sides += (mesh.vertices[triangle[(corner + 1) % 3]] - mesh.vertices[triangle[corner]]).norm();
    const double page = double(options.size) * options.size * options.pages;
    const double margin = options.gap / 2.0, area = surfaceArea(mesh);
    const double free = page - static_cast<double>(mesh.triangles.size()) * M_PI * margin * margin;
    const double half = sides * margin / 2;
    const double scale = (std::sqrt(half * half + area * free) - half) / area;
    return scale * scale * area / page;
}

} // namespace

INSTANTIATE_TEST_SUITE_P(Surfaces, AtlasOf, testing::ValuesIn(atlasCases()), [](const auto& info) {
    return std::string(info.param.name) +
           (info.param.options.layout == AtlasLayout::Rows             ? "InRows"
            : info.param.options.layout == AtlasLayout::MatchedRows    ? "InMatchedRows"
            : info.param.options.layout == AtlasLayout::UnfoldedGroups ? "InUnfoldedGroups"
                                                                       : "InCharts");
});

TEST(Atlas, UsesThePagesAsWellAsTheSource) {
    const TriangleMesh mesh = lumpySurface(100, 100);
    EXPECT_GT(packAtlas(mesh, {2048, 1, 2, AtlasLayout::Rows}).utilisation, 0.51);
    EXPECT_GT(packAtlas(mesh, {4096, 1, 2, AtlasLayout::Rows}).utilisation, 0.64);
}

TEST(Atlas, MatchedRowsComeNearWhatTrianglesCanUseAtAll) {
    const TriangleMesh mesh = lumpySurface(100, 100);
    for (const int size : {2048, 4096}) {
        const AtlasOptions options{size, 1, 2, AtlasLayout::MatchedRows};
        const double most = mostUse(mesh, options);
        EXPECT_LT(packAtlas(mesh, options).utilisation, most);
        EXPECT_GT(packAtlas(mesh, options).utilisation, 0.93 * most);
    }
}

TEST(Atlas, UnfoldedGroupsHaveFewSeams) {
    const AtlasOptions options{2048, 1, 2, AtlasLayout::UnfoldedGroups};
    for (const TriangleMesh& mesh : {lumpySurface(100, 100), lumpySurface(30, 200), flatSquare(0.1, 50)}) {
        const Atlas atlas = packAtlas(mesh, options);
        EXPECT_LT(seamShare(mesh, atlas), 0.45);
        EXPECT_GT(atlas.utilisation, 0.5);
    }
}

TEST(Atlas, UnfoldedGroupsOfSmallTrianglesUseMoreThanSingleOnesCould) {
    const TriangleMesh mesh = lumpySurface(100, 100);
    const AtlasOptions options{1024, 1, 2, AtlasLayout::UnfoldedGroups};
    EXPECT_GT(packAtlas(mesh, options).utilisation, mostUse(mesh, options));
}

TEST(Atlas, EveryEdgeOfSingleTrianglesIsASeam) {
    const TriangleMesh mesh = lumpySurface(20, 20);
    EXPECT_EQ(seamShare(mesh, packAtlas(mesh, {512, 1, 2, AtlasLayout::MatchedRows})), 1);
}

TEST(Atlas, MorePagesGiveMoreTexels) {
    const TriangleMesh mesh = lumpySurface(30, 40);
    for (const AtlasLayout layout : atlasLayouts) {
        const double one = packAtlas(mesh, {256, 1, 2, layout}).texelsPerMetre,
                     four = packAtlas(mesh, {256, 4, 2, layout}).texelsPerMetre;
        EXPECT_GT(four, 1.9 * one) << wordOf(layout);
    }
}

TEST(Atlas, TakesAsManyPagesAsTheTexelsAskedForNeed) {
    const TriangleMesh mesh = lumpySurface(30, 40);
    for (const AtlasLayout layout : atlasLayouts) {
        const double one = packAtlas(mesh, {256, 1, 2, layout}).texelsPerMetre;
        const Atlas atlas = packAtlas(mesh, {256, 1, 2, layout, 2 * one});
        EXPECT_EQ(atlas.texelsPerMetre, 2 * one);
        EXPECT_TRUE(atlas.options.pages >= 3 && atlas.options.pages <= 5) << atlas.options.pages;
        EXPECT_GE(smallestDistance(mesh, atlas), 2 - 1e-6);
        expectWithinPages(atlas);
        EXPECT_EQ(packAtlas(mesh, {256, 1, 2, layout, one / 4}).options.pages, 1);
        EXPECT_THAT(refusal(mesh, {256, 1, 2, layout, 20 * one}), HasSubstr("64 pages of 256 pixels"));
    }
    EXPECT_THAT(refusal(mesh, {256, 1, 2, AtlasLayout::Rows, -1}), HasSubstr("texels per metre"));
}

TEST(Atlas, UnfoldsNothingAcrossEdgesThatBranchOrTurnTheInsideOut) {
    TriangleMesh branching{{{0, 0, 0}, {1, 0, 0}, {0.5, 1, 0}, {0.5, -1, 0}, {0.5, 0, 1}},
                           {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}};
    TriangleMesh turned{{{0, 0, 0}, {1, 0, 0}, {0.5, 1, 0}, {0.5, -1, 0}}, {{0, 1, 2}, {0, 1, 3}}};
    for (const TriangleMesh& mesh : {branching, turned})
        for (const AtlasLayout layout : {AtlasLayout::UnfoldedGroups, AtlasLayout::Charts})
            EXPECT_EQ(seamShare(mesh, packAtlas(mesh, {64, 1, 2, layout})), 1) << wordOf(layout);
}

TEST(Atlas, GivesDegenerateTrianglesAPlaceOfTheirOwn) {
    TriangleMesh mesh = lumpySurface(10, 10);
    const auto proper = mesh.triangles.size();
    mesh.triangles.push_back({3, 3, 3});
    mesh.triangles.push_back({4, 5, 4});
    mesh.vertices.push_back((mesh.vertices[20] + mesh.vertices[21]) / 2);
    mesh.triangles.push_back({20, 21, static_cast<std::uint32_t>(mesh.vertices.size() - 1)});
    for (const AtlasLayout layout : atlasLayouts) {
        const Atlas atlas = packAtlas(mesh, {512, 1, 2, layout});
        for (std::size_t i = proper; i < mesh.triangles.size(); ++i)
            for (const Eigen::Vector2d& corner : atlas.corners[i])
                EXPECT_EQ(corner, atlas.corners[i][0]);
        EXPECT_GE(smallestDistance(mesh, atlas), 2 - 1e-6);
        expectWithinPages(atlas);
    }
}

TEST(Atlas, NamesTheSmallestSizeThatFits) {
    const TriangleMesh mesh = lumpySurface(30, 40);
    for (const AtlasOptions options :
         {AtlasOptions{64, 1, 2}, AtlasOptions{0, 1, 2}, AtlasOptions{-5, 2, 2}, AtlasOptions{256, 1, 40}}) {
        const std::string message = refusal(mesh, options);
        const std::string mark = "the smallest size that fits is ";
        ASSERT_THAT(message, HasSubstr(mark));
        const int size = std::stoi(message.substr(message.find(mark) + mark.size()));
        EXPECT_EQ(refusal(mesh, {size, options.pages, options.gap}), "");
        EXPECT_THAT(refusal(mesh, {size - 1, options.pages, options.gap}), HasSubstr(mark));
    }
}

TEST(Atlas, RefusesWhatCannotBe) {
    const TriangleMesh mesh = lumpySurface(10, 10);
    EXPECT_THAT(refusal(mesh, {16385, 0, -1}),
                testing::AllOf(HasSubstr("16384"), HasSubstr("the gap"), HasSubstr("number of pages")));
    EXPECT_THAT(refusal(mesh, {1024, 65, 2}), HasSubstr("pages must be from 1 to 64"));
    EXPECT_THAT(refusal(mesh, {1024, 1, 20000}), HasSubstr("gap must be from 0 to 16384"));
    EXPECT_THAT(refusal({}, {1024, 1, 2}), HasSubstr("no surface"));
    EXPECT_THAT(refusal({{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}}}, {1024, 1, 2}),
                HasSubstr("no surface"));
}
