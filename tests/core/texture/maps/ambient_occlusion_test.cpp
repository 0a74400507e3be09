#include "core/texture/maps/ambient_occlusion.h"

#include "tests/core/texture/layers/painted_pages.h"
#include "tests/support/sanitized.h"
#include "tests/support/steady_progress.h"
#include "tests/support/test_surfaces.h"

#include <map>

using namespace esm;
using namespace esm::test;

namespace {

/// A sphere of radius 1/10 m.
TriangleMesh roundSurface(int rings, int segments) {
    TriangleMesh mesh = lumpySurface(rings, segments);
    for (std::size_t i = 1; i + 1 < mesh.vertices.size(); ++i) {
        const auto ring = static_cast<int>(i - 1) / segments, segment = static_cast<int>(i - 1) % segments;
        const double polar = M_PI * (ring + 1) / rings, around = 2 * M_PI * segment / segments;
        mesh.vertices[i] = {0.1 * std::sin(polar) * std::cos(around),
                            0.1 * std::sin(polar) * std::sin(around), 0.1 * std::cos(polar)};
    }
    mesh.vertices.front() = {0, 0, 0.1};
    mesh.vertices.back() = {0, 0, -0.1};
    return mesh;
}

/// A floor and a wall of a tenth of a metre that meet at right angles along x = 0, seen from their corner.
TriangleMesh floorAndWall(int cells) {
    TriangleMesh mesh = flatSquare(0.1, cells);
    const std::vector<Triangle> floor = mesh.triangles;
    std::vector<std::uint32_t> onWall(mesh.vertices.size());
    for (std::uint32_t i = 0; i < onWall.size(); ++i) {
        mesh.vertices[i].x() += 0.05;
        const Eigen::Vector3d vertex = mesh.vertices[i];
        onWall[i] = vertex.x() < 1e-9 ? i : static_cast<std::uint32_t>(mesh.vertices.size());
        if (onWall[i] != i) mesh.vertices.emplace_back(0, vertex.y(), vertex.x());
    }
    for (const Triangle& triangle : floor)
        mesh.triangles.push_back({onWall[triangle[0]], onWall[triangle[2]], onWall[triangle[1]]});
    return mesh;
}

Atlas packed(const TriangleMesh& mesh) {
    return packAtlas(mesh, {256, 1, 2, AtlasLayout::MatchedRows});
}

struct Extremes {
    int least = 255, most = 0;
};

/// Of the texels whose place on the surface is asked for.
Extremes openness(const TriangleMesh& mesh, double reach,
                  const std::function<bool(const Eigen::Vector3d&)>& isAsked) {
    const Atlas atlas = packed(mesh);
    Extremes extremes;
    forEachTexelInside(mesh, atlas, occlusionPages(mesh, atlas, reach),
                       [&](const Eigen::Vector3d& place, const Colour& colour, std::size_t) {
                           EXPECT_EQ(colour[0], colour[1]);
                           EXPECT_EQ(colour[0], colour[2]);
                           EXPECT_EQ(colour[3], 255);
                           if (!isAsked(place)) return;
                           extremes.least = std::min(extremes.least, int(colour[0]));
                           extremes.most = std::max(extremes.most, int(colour[0]));
                       });
    return extremes;
}

bool everywhere(const Eigen::Vector3d& /*place*/) {
    return true;
}

} // namespace

// A chord of a sphere at angle a from the normal has the length 2 R cos a. Light counts by cos a, so that of
// the reach r a place inside sees 1 − ∫ 2 u (1 − 2 R u / r)² du = 4/3 · (2 R / r) − 1/2 · (2 R / r)².
TEST(AmbientOcclusion, InsideASphereIsWhatTheIntegralSays) {
    TriangleMesh mesh = roundSurface(40, 60);
    for (Triangle& triangle : mesh.triangles)
        std::swap(triangle[1], triangle[2]);
    for (const double reach : {0.2, 0.4}) {
        const double ratio = 0.2 / reach, expected = 255 * (4 * ratio / 3 - ratio * ratio / 2);
        const Extremes found = openness(mesh, reach, everywhere);
        EXPECT_NEAR(found.least, expected, 4) << reach;
        EXPECT_NEAR(found.most, expected, 4) << reach;
    }
}

TEST(AmbientOcclusion, LeavesConvexAndFlatSurfacesBright) {
    EXPECT_EQ(openness(roundSurface(12, 16), 0.1, everywhere).least, 255);
    EXPECT_EQ(openness(flatSquare(0.1, 1), 0.02, everywhere).least, 255);
    EXPECT_EQ(openness(flatSquare(0.1, 8), 0.02, everywhere).least, 255);
}

// At x from an endless wall, the directions that meet it within the reach r take (1 − x / (r u))² of their
// light, u being how far they go towards it; the integral over the hemisphere was taken numerically.
TEST(AmbientOcclusion, BesideAWallIsWhatTheIntegralSays) {
    constexpr double reach = 0.03;
    const std::map<double, double> expected{{0.25, 0.904}, {0.5, 0.983}, {0.75, 0.999}, {1.01, 1}};
    for (const int cells : {1, 16}) { // few large triangles say the same as many small ones
        const TriangleMesh mesh = floorAndWall(cells);
        for (const auto& expectation : expected) {
            const double share = expectation.first, open = expectation.second;
            const Extremes found = openness(mesh, reach, [&](const Eigen::Vector3d& place) {
                const double fromWall = std::max(place.x(), place.z());
                return std::abs(place.y()) < 0.02 && std::abs(fromWall - share * reach) < 0.0005;
            });
            EXPECT_NEAR(found.least, 255 * open, 0.03 * 255) << cells << " " << share;
            EXPECT_NEAR(found.most, 255 * open, 0.03 * 255) << cells << " " << share;
        }
        const Extremes fold = openness(mesh, reach, [](const Eigen::Vector3d& place) {
            return std::abs(place.y()) < 0.02 && std::max(place.x(), place.z()) < 0.0015;
        });
        EXPECT_LT(fold.most, 255 * 0.75) << cells;
    }
}

TEST(AmbientOcclusion, ShowsNoStepAtSeams) {
    const TriangleMesh mesh = lumpySurface(20, 24);
    const auto errorAt = [&](int size) {
        const Atlas atlas = packAtlas(mesh, {size, 1, 2, AtlasLayout::UnfoldedGroups});
        return seamError(mesh, atlas, occlusionPages(mesh, atlas, 0.05));
    };
    // What is left is how steep the shade is: it goes with the size of a texel.
    const double coarse = errorAt(256), fine = errorAt(2048);
    EXPECT_LT(fine, 8);
    EXPECT_LT(fine, 0.3 * coarse);
}

TEST(AmbientOcclusion, TellsHowFarItIsAndCanBeStopped) {
    const TriangleMesh mesh = isSanitized() ? lumpySurface(12, 18) : lumpySurface(40, 60);
    const Atlas atlas = packed(mesh);
    expectGoodProgress([&](const Progress& progress) { occlusionPages(mesh, atlas, 0.02, progress); });
}
