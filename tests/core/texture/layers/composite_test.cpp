#include "core/texture/layers/composite.h"

#include "core/exchange/meshes/mesh_file.h"
#include "core/geometry/repair.h"
#include "core/support/errors.h"
#include "tests/core/texture/layers/painted_pages.h"
#include "tests/support/shared_data.h"
#include "tests/support/test_surfaces.h"

#include <gtest/gtest.h>

#include <tbb/global_control.h>

using namespace esm;
using namespace esm::test;

namespace {

/// A square of 0.1 m at z = 0 and a smaller one of 0.04 m above its middle, both seen from above.
TriangleMesh squareUnderSquare() {
    TriangleMesh mesh = flatSquare(0.1, 4), above = flatSquare(0.04, 2);
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (const Eigen::Vector3d& vertex : above.vertices)
        mesh.vertices.emplace_back(vertex + Eigen::Vector3d(0, 0, 0.05));
    for (const Triangle& t : above.triangles)
        mesh.triangles.push_back({first + t[0], first + t[1], first + t[2]});
    return mesh;
}

} // namespace

TEST(Composite, IsTheBaseColourWithoutPhotos) {
    const TriangleMesh mesh = flatSquare(0.1, 3);
    const Atlas atlas = packAtlas(mesh, {128, 2, 2});
    const std::vector<Image> pages = composite(mesh, atlas, {}, baseColour);
    ASSERT_EQ(pages.size(), 2U);
    for (const Image& page : pages) {
        ASSERT_EQ(page.pixels.size(), 4U * 128 * 128);
        for (int i = 0; i < 128 * 128; ++i)
            ASSERT_EQ(pixelAt(page, i % 128, i / 128), base);
    }
}

TEST(Composite, KeepsASquareOfACheckerboardWhereItIs) {
    const TriangleMesh mesh = flatSquare(0.1, 7);
    const Atlas atlas = packAtlas(mesh, {1024, 1, 2});
    // 8 × 8 squares of 32 pixels over 0.08 m; the one at the top left is red, so that no mirroring goes
    // unseen.
    const std::vector<Image> pages =
        composite(mesh, atlas, {layerFromAbove(checkerboard(), 0.08)}, baseColour);
    int compared = 0;
    forEachTexelInside(mesh, atlas, pages,
                       [&](const Eigen::Vector3d& point, const Colour& colour, std::size_t) {
                           const double column = (point.x() + 0.04) / 0.01, row = (0.04 - point.y()) / 0.01;
                           if (fromLine(column, row) < 2 / (0.01 * atlas.texelsPerMetre))
                               return; // within two texels of a line colours mix
                           ++compared;
                           EXPECT_EQ(colour, colourOfSquare(column, row)) << point.transpose();
                       });
    EXPECT_GT(compared, 100000);
}

TEST(Composite, MixesAHalfTransparentPhotoEvenly) {
    const TriangleMesh mesh = flatSquare(0.1, 3);
    const Atlas atlas = packAtlas(mesh, {256, 1, 2});
    const TextureLayer byAlpha = layerFromAbove(plainPhoto({0, 255, 0, 51}), 0.3);
    TextureLayer byOpacity = layerFromAbove(plainPhoto(green), 0.3);
    byOpacity.opacity = 0.5;
    const auto expectEverywhere = [&](const TextureLayer& layer, const Colour& expected) {
        const std::vector<Image> pages = composite(mesh, atlas, {layer}, baseColour);
        forEachTexelInside(mesh, atlas, pages,
                           [&](auto&, const Colour& colour, std::size_t) { ASSERT_EQ(colour, expected); });
    };
    expectEverywhere(byAlpha, {160, 132, 40, 255}); // 51 / 255 is a fifth
    expectEverywhere(byOpacity, {100, 178, 25, 255});
}

TEST(Composite, LaysLaterPhotosOverEarlierOnes) {
    const TriangleMesh mesh = flatSquare(0.1, 3);
    const Atlas atlas = packAtlas(mesh, {256, 1, 2});
    std::vector<TextureLayer> layers{layerFromAbove(plainPhoto(green), 0.3),
                                     layerFromAbove(plainPhoto({0, 0, 255, 255}), 0.3)};
    const auto expectAll = [&](const Colour& expected) {
        const std::vector<Image> pages = composite(mesh, atlas, layers, baseColour);
        forEachTexelInside(mesh, atlas, pages,
                           [&](auto&, const Colour& colour, std::size_t) { ASSERT_EQ(colour, expected); });
    };
    expectAll({0, 0, 255, 255});
    std::swap(layers[0], layers[1]);
    expectAll(green);
    layers[1].visible = false;
    expectAll({0, 0, 255, 255});
    layers[0].opacity = 0;
    expectAll(base);
}

TEST(Composite, WeighsThePhotoLinearlyFromItsBorder) {
    const TriangleMesh mesh = flatSquare(0.1, 3);
    const Atlas atlas = packAtlas(mesh, {1024, 1, 2});
    const auto photo = makePhoto(100, 50, [](int, int) { return green; });
    TextureLayer layer = layerFromAbove(photo, 0.1);
    layer.projector.height = 0.05; // 1 mm per pixel both ways
    layer.blendPixels = 20;
    const std::vector<Image> pages = composite(mesh, atlas, {layer}, baseColour);
    forEachTexelInside(
        mesh, atlas, pages, [&](const Eigen::Vector3d& point, const Colour& colour, std::size_t) {
            const double inside = std::min(50 - std::abs(point.x()) * 1000, 25 - std::abs(point.y()) * 1000);
            const double weight = std::clamp(inside / 20, 0.0, 1.0);
            ASSERT_NEAR(colour[0], 200 * (1 - weight), 0.51);
            ASSERT_NEAR(colour[1], 101 + 154 * weight, 0.51);
        });
}

TEST(Composite, ColoursOnlyWhatTheProjectorSees) {
    const TriangleMesh mesh = squareUnderSquare();
    const Atlas atlas = packAtlas(mesh, {512, 1, 2});
    const TextureLayer layer = layerFromAbove(plainPhoto(green), 0.3);
    const std::vector<Image> pages = composite(mesh, atlas, {layer}, baseColour);
    int lit = 0, hidden = 0;
    forEachTexelInside(mesh, atlas, pages,
                       [&](const Eigen::Vector3d& point, const Colour& colour, std::size_t) {
                           const double fromMiddle = std::max(std::abs(point.x()), std::abs(point.y()));
                           if (std::abs(fromMiddle - 0.02) < 1e-4) return; // the shadow's very border
                           const bool isHidden = point.z() < 0.01 && fromMiddle < 0.02;
                           ++(isHidden ? hidden : lit);
                           ASSERT_EQ(colour, isHidden ? base : green) << point.transpose();
                       });
    EXPECT_GT(hidden, 1000);
    EXPECT_GT(lit, 1000);
}

TEST(Composite, ColoursHiddenAndBackSidesOnlyWithoutOcclusion) {
    TriangleMesh mesh = squareUnderSquare();
    for (Triangle& triangle : mesh.triangles)
        std::swap(triangle[1], triangle[2]);
    const Atlas atlas = packAtlas(mesh, {512, 1, 2});
    TextureLayer layer = layerFromAbove(plainPhoto(green), 0.3);
    const std::vector<Image> untouched = composite(mesh, atlas, {layer}, baseColour);
    layer.projector.occlusion = false;
    const std::vector<Image> touched = composite(mesh, atlas, {layer}, baseColour);
    forEachTexelInside(mesh, atlas, untouched,
                       [](auto&, const Colour& colour, std::size_t) { ASSERT_EQ(colour, base); });
    forEachTexelInside(mesh, atlas, touched,
                       [](auto&, const Colour& colour, std::size_t) { ASSERT_EQ(colour, green); });
}

/// A sheet on edge: the smooth normals of all its corners stand at right angles to the light.
TEST(Composite, ColoursWhatIsSeenEdgeOnWithoutOcclusion) {
    TriangleMesh mesh = flatSquare(0.1, 3);
    for (Eigen::Vector3d& vertex : mesh.vertices)
        vertex = {vertex.x(), 0, vertex.y()};
    const Atlas atlas = packAtlas(mesh, {512, 1, 2});
    TextureLayer layer = layerFromAbove(plainPhoto(green), 0.3);
    layer.projector.pose.translation().z() = 0.1;
    layer.projector.occlusion = false;
    for (const double blendPixels : {0.0, 0.5}) {
        layer.blendPixels = blendPixels;
        forEachTexelInside(mesh, atlas, composite(mesh, atlas, {layer}, baseColour),
                           [](auto&, const Colour& colour, std::size_t) { ASSERT_EQ(colour, green); });
    }
}

TEST(Composite, LeavesWhatLiesBehindThePhotosPlane) {
    const TriangleMesh mesh = squareUnderSquare();
    const Atlas atlas = packAtlas(mesh, {512, 1, 2});
    TextureLayer layer = layerFromAbove(plainPhoto(green), 0.3);
    layer.projector.pose.translation().z() = 0.025; // between the two squares
    for (const bool occlusion : {false, true}) {
        layer.projector.occlusion = occlusion;
        const std::vector<Image> pages = composite(mesh, atlas, {layer}, baseColour);
        forEachTexelInside(mesh, atlas, pages,
                           [](const Eigen::Vector3d& point, const Colour& colour, std::size_t) {
                               ASSERT_EQ(colour, point.z() < 0.025 ? green : base);
                           });
    }
}

TEST(Composite, ReadsAFinePatternAsItsMean) {
    const TriangleMesh mesh = flatSquare(0.1, 3);
    const Atlas atlas = packAtlas(mesh, {128, 1, 2});
    const auto photo = makePhoto(1024, 1024, [](int x, int y) {
        return (x + y) % 2 == 0 ? Colour{255, 255, 255, 255} : Colour{0, 0, 0, 255};
    });
    const std::vector<Image> pages = composite(mesh, atlas, {layerFromAbove(photo, 0.1)}, baseColour);
    forEachTexelInside(mesh, atlas, pages, [](auto&, const Colour& colour, std::size_t) {
        ASSERT_TRUE(isNear(colour, {128, 128, 128, 255}, 2)) << int(colour[0]);
    });
}

TEST(Composite, DoesNotLetTransparentPixelsBleed) {
    const TriangleMesh mesh = flatSquare(0.1, 3);
    const Atlas atlas = packAtlas(mesh, {256, 1, 2});
    const auto photo = makePhoto(512, 512, [](int x, int) {
        return x < 256 ? green : Colour{255, 0, 255, 0};
    });
    const std::vector<Image> pages = composite(mesh, atlas, {layerFromAbove(photo, 0.1)}, {0, 0, 0});
    forEachTexelInside(mesh, atlas, pages, [](auto&, const Colour& colour, std::size_t) {
        ASSERT_EQ(colour[0], 0);
        ASSERT_EQ(colour[2], 0);
    });
}

TEST(Composite, IsTheSameWithAnyNumberOfThreads) {
    const TriangleMesh mesh = lumpySurface(30, 40);
    const Atlas atlas = packAtlas(mesh, {512, 2, 2});
    const auto photo = makePhoto(300, 200, [](int x, int y) {
        return Colour{std::uint8_t(x * 7), std::uint8_t(y * 11), std::uint8_t(x * y), std::uint8_t(x + y)};
    });
    const std::vector<TextureLayer> layers{layerFromAbove(photo, 0.15), layerFromAbove(photo, 0.1)};
    const auto composeWith = [&](std::size_t threads) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        return composite(mesh, atlas, layers, baseColour);
    };
    const std::vector<Image> one = composeWith(1), two = composeWith(2);
    ASSERT_EQ(one.size(), two.size());
    for (std::size_t page = 0; page < one.size(); ++page)
        EXPECT_EQ(one[page].pixels, two[page].pixels);
}

TEST(Composite, StopsWhenToldTo) {
    const TriangleMesh mesh = flatSquare(0.1, 3);
    const Atlas atlas = packAtlas(mesh, {256, 1, 2});
    const std::vector<TextureLayer> layers{layerFromAbove(plainPhoto(green), 0.1)};
    EXPECT_THROW(composite(mesh, atlas, layers, baseColour, [](double) { return false; }), Cancelled);
}

TEST(Composite, RefusesTheLayoutOfAnotherSurfaceOrBeyondThePage) {
    const TriangleMesh mesh = flatSquare(0.1, 3);
    Atlas atlas = packAtlas(mesh, {256, 1, 2});
    EXPECT_THROW(composite(flatSquare(0.1, 4), atlas, {}, baseColour), InvalidModel);
    atlas.corners[0][0].y() = 1e300;
    const TextureLayer layer = layerFromAbove(plainPhoto(green), 0.3);
    EXPECT_THROW(composite(mesh, atlas, {layer}, baseColour), InvalidModel);
    EXPECT_THROW(coverage(mesh, atlas, layer), InvalidModel);
}

TEST(Composite, GivesPatchesWithoutAreaAColourLikePoints) {
    const TriangleMesh mesh = flatSquare(0.1, 3);
    const TextureLayer layer = layerFromAbove(plainPhoto(green), 0.3);
    for (const double off : {0.0, 1e-300, 1e-14, 1e-9}) {
        Atlas atlas = packAtlas(mesh, {256, 1, 2});
        atlas.corners[0] = {Eigen::Vector2d(10, 10), {30, 30 + off}, {50, 50}};
        const std::vector<Image> pages = composite(mesh, atlas, {layer}, baseColour);
        const Colour colour = pixelAt(pages[0], 30, 30);
        EXPECT_TRUE(colour == green || colour == base) << off;
        EXPECT_GT(coverage(mesh, atlas, layer).triangles, 1U);
    }
}

TEST(Composite, TakesNoColourFromPlacesThatAreNotFinite) {
    const TriangleMesh mesh = flatSquare(0.1, 3);
    const Atlas atlas = packAtlas(mesh, {256, 1, 2});
    TextureLayer layer = layerFromAbove(plainPhoto(green), 1e-308);
    layer.projector.occlusion = false;
    forEachTexelInside(mesh, atlas, composite(mesh, atlas, {layer}, baseColour),
                       [](auto&, const Colour& colour, std::size_t) { ASSERT_EQ(colour, base); });
}

TEST(Coverage, CountsTexelsAndTriangles) {
    const TriangleMesh mesh = flatSquare(0.1, 4);
    const Atlas atlas = packAtlas(mesh, {512, 1, 2});
    TextureLayer layer = layerFromAbove(plainPhoto(green), 0.3);
    const LayerCoverage all = coverage(mesh, atlas, layer);
    EXPECT_EQ(all.triangles, mesh.triangles.size());
    EXPECT_NEAR(double(all.texels), atlas.utilisation * 512 * 512, 0.01 * 512 * 512);
    layer.projector.width = layer.projector.height = 0.05; // the middle 2 × 2 of 4 × 4 cells
    layer.projector.pose.translation().x() = 1e-5;         // off the grid lines by less than a texel
    const LayerCoverage middle = coverage(mesh, atlas, layer);
    EXPECT_NEAR(double(middle.texels) / double(all.texels), 0.25, 0.01);
    EXPECT_GE(middle.triangles, 8U);
    layer.projector.pose.translation().x() = 1;
    EXPECT_EQ(coverage(mesh, atlas, layer).triangles, 0U);
    EXPECT_EQ(coverage(mesh, atlas, layer).texels, 0U);
}

TEST(SeamError, IsSmallForASmoothPhotoAndSeesAForeignColour) {
    const TriangleMesh mesh = lumpySurface(30, 40);
    const Atlas atlas = packAtlas(mesh, {1024, 1, 4});
    const auto photo = makePhoto(64, 64, [](int x, int y) {
        return Colour{std::uint8_t(2 * x + 40), std::uint8_t(2 * y + 60), std::uint8_t(x + y), 255};
    });
    TextureLayer layer = layerFromAbove(photo, 0.4);
    layer.projector.occlusion = false;
    std::vector<Image> pages = composite(mesh, atlas, {layer}, baseColour);
    EXPECT_LE(seamError(mesh, atlas, pages), 2);
    const Eigen::Vector2d middle = (atlas.corners[100][0] + atlas.corners[100][1]) / 2;
    pages[0].at(int(middle.x()), int(middle.y()))[1] ^= 0x80;
    EXPECT_GT(seamError(mesh, atlas, pages), 10);
}

/// Some of its vertices have more than a full angle of surface around them: unfolded, triangles come to lie
/// side by side that have others between them.
TEST(SeamError, IsSmallWhereUnfoldedTrianglesMeetInOneCorner) {
    ESM_SKIP_WITHOUT(sharedData("meshes/sofa-liver-coarse.obj"));
    const TriangleMesh mesh = repair(readMeshFile(sharedData("meshes/sofa-liver-coarse.obj"))).mesh;
    const auto photo = makePhoto(256, 256, [](int x, int y) {
        return Colour{std::uint8_t(x / 2), std::uint8_t(y / 2 + 60), std::uint8_t((x + y) / 4), 255};
    });
    const Eigen::AlignedBox3d box = boundingBox(mesh.vertices);
    TextureLayer layer = layerFromAbove(photo, 1.6 * box.sizes().maxCoeff());
    layer.projector.pose.translation() = box.center() + Eigen::Vector3d(0, 0, box.sizes().z());
    layer.projector.occlusion = false;
    const Atlas atlas = packAtlas(mesh, {2048, 1, 8, AtlasLayout::UnfoldedGroups});
    EXPECT_LE(seamError(mesh, atlas, composite(mesh, atlas, {layer}, baseColour)), 2);
}

TEST(Composite, LaysARealPhotoOnARealLiver) {
    ESM_SKIP_WITHOUT(sharedData("meshes/VH_M_Liver.glb"));
    ESM_SKIP_WITHOUT(sharedData("images/lap-liver-gallbladder.jpg"));
    const TriangleMesh mesh = repair(readMeshFile(sharedData("meshes/VH_M_Liver.glb"))).mesh;
    const Atlas atlas = packAtlas(mesh, {1024, 1, 1});
    const Eigen::AlignedBox3d box = boundingBox(mesh.vertices);
    TextureLayer layer;
    layer.photo = loadPhoto(sharedData("images/lap-liver-gallbladder.jpg"));
    layer.projector.pose.translation() = box.center() + Eigen::Vector3d(0, 0, box.sizes().z());
    layer.projector.width = 0.4;
    layer.projector.height = 0.4 * 1080 / 1920;
    layer.blendPixels = 0; // what fades out may leave the base colour as it is
    const std::vector<Image> pages = composite(mesh, atlas, {layer}, baseColour);
    std::size_t lit = 0, untouchedBack = 0, back = 0;
    forEachTexelInside(mesh, atlas, pages, [&](auto&, const Colour& colour, std::size_t triangle) {
        const Triangle& t = mesh.triangles[triangle];
        const Eigen::Vector3d u = mesh.vertices[t[1]] - mesh.vertices[t[0]];
        const Eigen::Vector3d v = mesh.vertices[t[2]] - mesh.vertices[t[0]];
        const bool faces = u.cross(v).z() > 0;
        lit += faces && colour != base ? 1 : 0;
        back += faces ? 0 : 1;
        untouchedBack += !faces && colour == base ? 1 : 0;
    });
    EXPECT_EQ(untouchedBack, back);
    const auto covered = double(coverage(mesh, atlas, layer).texels);
    EXPECT_LE(double(lit), covered);
    EXPECT_GT(double(lit), 0.999 * covered); // a slight weight may leave the base colour as it is
    EXPECT_GT(lit, 10000U);
}
