#include "core/texture/composite.h"

#include "core/exchange/mesh_file.h"
#include "core/geometry/repair.h"
#include "core/support/errors.h"
#include "tests/support/shared_data.h"
#include "tests/support/test_meshes.h"
#include "tests/support/test_surfaces.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <functional>
#include <tbb/global_control.h>

using namespace esm;
using Colour = std::array<std::uint8_t, 4>;

namespace {

constexpr std::array<std::uint8_t, 3> baseColour{200, 101, 50};

std::shared_ptr<const Photo> makePhoto(int width, int height,
                                       const std::function<Colour(int x, int y)>& colour) {
    auto photo = std::make_shared<Photo>();
    photo->image.width = width;
    photo->image.height = height;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (const std::uint8_t channel : colour(x, y))
                photo->image.pixels.push_back(channel);
    return photo;
}

std::shared_ptr<const Photo> plainPhoto(const Colour& colour) {
    return makePhoto(8, 8, [&](int, int) { return colour; });
}

/// Thrown from z = 1 m straight down onto the origin.
PhotoLayer layerFromAbove(std::shared_ptr<const Photo> photo, double width) {
    PhotoLayer layer;
    layer.photo = std::move(photo);
    layer.projector.pose.translation().z() = 1;
    layer.projector.width = layer.projector.height = width;
    layer.blendPixels = 0;
    return layer;
}

Colour pixelAt(const Image& page, int x, int y) {
    const std::uint8_t* pixel = page.at(x, y);
    return {pixel[0], pixel[1], pixel[2], pixel[3]};
}

/// Calls `visit(surface point, colour, triangle)` for every texel whose centre lies inside a patch, and fails
/// where there are too few to tell anything.
void forEachTexelInside(
    const TriangleMesh& mesh, const Atlas& atlas, const std::vector<Image>& pages,
    const std::function<void(const Eigen::Vector3d&, const Colour&, std::size_t)>& visit) {
    std::size_t visited = 0;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const auto& patch = atlas.corners[i];
        Eigen::AlignedBox2d box;
        for (const Eigen::Vector2d& corner : patch)
            box.extend(corner);
        Eigen::Matrix2d sides;
        sides << patch[1] - patch[0], patch[2] - patch[0];
        for (int y = int(box.min().y()); y <= int(box.max().y()); ++y) {
            for (int x = int(box.min().x()); x <= int(box.max().x()); ++x) {
                const Eigen::Vector2d w = sides.inverse() * (Eigen::Vector2d(x + 0.5, y + 0.5) - patch[0]);
                if (w.minCoeff() < 0 || w.sum() > 1) continue;
                ++visited;
                const Triangle& t = mesh.triangles[i];
                visit((1 - w.sum()) * mesh.vertices[t[0]] + w.x() * mesh.vertices[t[1]] +
                          w.y() * mesh.vertices[t[2]],
                      pixelAt(pages[atlas.page[i]], x, y), i);
            }
        }
    }
    EXPECT_GT(visited, 2000U);
}

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

bool isNear(const Colour& colour, const Colour& expected, int tolerance) {
    for (std::size_t i = 0; i < 3; ++i)
        if (std::abs(int(colour[i]) - int(expected[i])) > tolerance) return false;
    return true;
}

constexpr Colour base{200, 101, 50, 255}, green{0, 255, 0, 255};

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
    const auto photo = makePhoto(256, 256, [](int x, int y) {
        if (x < 32 && y < 32) return Colour{255, 0, 0, 255};
        return (x / 32 + y / 32) % 2 == 0 ? Colour{255, 255, 255, 255} : Colour{0, 0, 0, 255};
    });
    const std::vector<Image> pages = composite(mesh, atlas, {layerFromAbove(photo, 0.08)}, baseColour);
    int compared = 0;
    forEachTexelInside(
        mesh, atlas, pages, [&](const Eigen::Vector3d& point, const Colour& colour, std::size_t) {
            const double column = (point.x() + 0.04) / 0.01, row = (0.04 - point.y()) / 0.01;
            const double fromLine =
                std::min(std::abs(column - std::round(column)), std::abs(row - std::round(row)));
            if (fromLine < 2 / (0.01 * atlas.texelsPerMetre))
                return; // within two texels of a line colours mix
            Colour expected = base;
            if (column > 0 && column < 8 && row > 0 && row < 8) {
                expected =
                    (int(column) + int(row)) % 2 == 0 ? Colour{255, 255, 255, 255} : Colour{0, 0, 0, 255};
                if (column < 1 && row < 1) expected = {255, 0, 0, 255};
            }
            ++compared;
            EXPECT_EQ(colour, expected) << point.transpose();
        });
    EXPECT_GT(compared, 100000);
}

TEST(Composite, MixesAHalfTransparentPhotoEvenly) {
    const TriangleMesh mesh = flatSquare(0.1, 3);
    const Atlas atlas = packAtlas(mesh, {256, 1, 2});
    const PhotoLayer byAlpha = layerFromAbove(plainPhoto({0, 255, 0, 51}), 0.3);
    PhotoLayer byOpacity = layerFromAbove(plainPhoto(green), 0.3);
    byOpacity.opacity = 0.5;
    const auto expectEverywhere = [&](const PhotoLayer& layer, const Colour& expected) {
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
    std::vector<PhotoLayer> layers{layerFromAbove(plainPhoto(green), 0.3),
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
    PhotoLayer layer = layerFromAbove(photo, 0.1);
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
    const PhotoLayer layer = layerFromAbove(plainPhoto(green), 0.3);
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
    PhotoLayer layer = layerFromAbove(plainPhoto(green), 0.3);
    const std::vector<Image> untouched = composite(mesh, atlas, {layer}, baseColour);
    layer.projector.occlusion = false;
    const std::vector<Image> touched = composite(mesh, atlas, {layer}, baseColour);
    forEachTexelInside(mesh, atlas, untouched,
                       [](auto&, const Colour& colour, std::size_t) { ASSERT_EQ(colour, base); });
    forEachTexelInside(mesh, atlas, touched,
                       [](auto&, const Colour& colour, std::size_t) { ASSERT_EQ(colour, green); });
}

TEST(Composite, LeavesWhatLiesBehindThePhotosPlane) {
    const TriangleMesh mesh = squareUnderSquare();
    const Atlas atlas = packAtlas(mesh, {512, 1, 2});
    PhotoLayer layer = layerFromAbove(plainPhoto(green), 0.3);
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

namespace {

/// Of 0.1 m, around the origin.
TriangleMesh centredCube() {
    return repair(test::cubeSoup(0.1, Eigen::Vector3d::Constant(-0.05))).mesh;
}

TriangleMesh turnedInsideOut(TriangleMesh mesh) {
    for (Triangle& triangle : mesh.triangles)
        std::swap(triangle[1], triangle[2]);
    return mesh;
}

/// From an eye 0.3 m away from the origin, at so many degrees from the z axis, with 8 × 8 squares of 32
/// pixels.
PhotoLayer checkerboardInPerspective(double degrees) {
    PhotoLayer layer;
    layer.photo = makePhoto(256, 256, [](int x, int y) {
        if (x < 32 && y < 32) return Colour{255, 0, 0, 255};
        return (x / 32 + y / 32) % 2 == 0 ? Colour{255, 255, 255, 255} : Colour{0, 0, 0, 255};
    });
    layer.projector.pose =
        Eigen::AngleAxisd(degrees * M_PI / 180, Eigen::Vector3d::UnitX()) * Eigen::Translation3d(0, 0, 0.3);
    layer.projector.kind = ProjectorKind::Perspective;
    layer.projector.fieldOfView = 14;
    layer.blendPixels = 0;
    return layer;
}

} // namespace

TEST(Composite, KeepsTheSquaresOfAPerspectivePhotoSeenAtSixtyDegrees) {
    const TriangleMesh mesh = flatSquare(0.1, 2); // few triangles: nothing is linear over one of them
    const Atlas atlas = packAtlas(mesh, {1024, 1, 2});
    const PhotoLayer layer = checkerboardInPerspective(60);
    const std::vector<Image> pages = composite(mesh, atlas, {layer}, baseColour);
    int compared = 0;
    forEachTexelInside(
        mesh, atlas, pages, [&](const Eigen::Vector3d& point, const Colour& colour, std::size_t) {
            // The eye's own geometry, without the projector's functions.
            const Eigen::Vector3d seen = layer.projector.pose.inverse() * point;
            const double edge = std::tan(7 * M_PI / 180);
            const double column = 4 + 4 * seen.x() / (-seen.z() * edge),
                         row = 4 - 4 * seen.y() / (-seen.z() * edge);
            // Seen slantwise, a texel is up to so many squares high or wide, and so far colours mix.
            const double mixed = 2 * 4 / (0.25 * edge * atlas.texelsPerMetre);
            if (std::min(std::abs(column - std::round(column)), std::abs(row - std::round(row))) < mixed)
                return;
            Colour expected = base;
            if (column > 0 && column < 8 && row > 0 && row < 8) {
                expected =
                    (int(column) + int(row)) % 2 == 0 ? Colour{255, 255, 255, 255} : Colour{0, 0, 0, 255};
                if (column < 1 && row < 1) expected = {255, 0, 0, 255};
            }
            ++compared;
            ASSERT_EQ(colour, expected) << point.transpose() << ", column " << column << ", row " << row;
        });
    EXPECT_GT(compared, 100000);
}

TEST(Composite, ColoursFromAnEyeInsideWhatThePhotoShows) {
    for (const TriangleMesh& mesh : {centredCube(), turnedInsideOut(centredCube())}) {
        const Atlas atlas = packAtlas(mesh, {512, 1, 2});
        PhotoLayer layer;
        layer.photo = plainPhoto(green);
        layer.blendPixels = 0;
        layer.projector.kind = ProjectorKind::Perspective; // in the cube's middle, looking along −z
        layer.projector.fieldOfView = 150;                 // reaches around the corners of the far wall
        const std::vector<Image> pages = composite(mesh, atlas, {layer}, baseColour);
        const double slope = std::tan(75 * M_PI / 180);
        forEachTexelInside(
            mesh, atlas, pages, [&](const Eigen::Vector3d& point, const Colour& colour, std::size_t) {
                const double edge = std::max(std::abs(point.x()), std::abs(point.y())) + slope * point.z();
                if (std::abs(edge) < 1e-3) return;
                ASSERT_EQ(colour, edge < 0 ? green : base) << point.transpose();
            });
    }
}

TEST(Composite, ColoursNothingThroughAWallThatAnEyeLooksAt) {
    const TriangleMesh mesh = centredCube();
    const Atlas atlas = packAtlas(mesh, {512, 1, 2});
    PhotoLayer layer;
    layer.photo = plainPhoto(green);
    layer.blendPixels = 0;
    layer.projector.kind = ProjectorKind::Perspective;
    layer.projector.pose.translation().z() = 0.3;
    layer.projector.fieldOfView = 60;
    for (const bool occlusion : {true, false}) {
        layer.projector.occlusion = occlusion;
        const std::vector<Image> pages = composite(mesh, atlas, {layer}, baseColour);
        forEachTexelInside(mesh, atlas, pages,
                           [&](const Eigen::Vector3d& point, const Colour& colour, std::size_t) {
                               const bool isFront = point.z() > 0.05 - 1e-9;
                               if (!isFront && point.z() > 0.0495) return; // the front's very border
                               ASSERT_EQ(colour, isFront || !occlusion ? green : base) << point.transpose();
                           });
    }
}

TEST(Composite, FadesAPhotoWhereSurfaceSlantsOnlyWhenAsked) {
    const TriangleMesh mesh = flatSquare(0.1, 3);
    const Atlas atlas = packAtlas(mesh, {256, 1, 2});
    PhotoLayer layer = layerFromAbove(plainPhoto({0, 255, 0, 255}), 0.5);
    layer.projector.pose =
        Eigen::AngleAxisd(72.5 * M_PI / 180, Eigen::Vector3d::UnitX()) * Eigen::Translation3d(0, 0, 1);
    for (const bool falloff : {false, true}) {
        layer.projector.falloff = falloff;
        const std::vector<Image> pages = composite(mesh, atlas, {layer}, baseColour);
        forEachTexelInside(mesh, atlas, pages, [&](auto&, const Colour& colour, std::size_t) {
            ASSERT_TRUE(isNear(colour, falloff ? Colour{100, 178, 25, 255} : green, 1));
        });
    }
}

TEST(Composite, TakesNothingFromAnEyeInTheSurface) {
    const TriangleMesh mesh = flatSquare(0.1, 3);
    const Atlas atlas = packAtlas(mesh, {128, 1, 2});
    PhotoLayer layer = checkerboardInPerspective(0);
    for (const double height : {0.0, 1e-300, 1e-12, -1e-12}) {
        layer.projector.pose =
            Eigen::Translation3d(0, 0, height) * Eigen::AngleAxisd(M_PI / 2, Eigen::Vector3d::UnitX());
        EXPECT_NO_THROW(composite(mesh, atlas, {layer}, baseColour));
        EXPECT_NO_THROW(coverage(mesh, atlas, layer));
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
    const std::vector<PhotoLayer> layers{layerFromAbove(photo, 0.15), layerFromAbove(photo, 0.1)};
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
    const std::vector<PhotoLayer> layers{layerFromAbove(plainPhoto(green), 0.1)};
    EXPECT_THROW(composite(mesh, atlas, layers, baseColour, [](double) { return false; }), Cancelled);
}

TEST(Composite, RefusesTheLayoutOfAnotherSurfaceOrBeyondThePage) {
    const TriangleMesh mesh = flatSquare(0.1, 3);
    Atlas atlas = packAtlas(mesh, {256, 1, 2});
    EXPECT_THROW(composite(flatSquare(0.1, 4), atlas, {}, baseColour), InvalidModel);
    atlas.corners[0][0].y() = 1e300;
    const PhotoLayer layer = layerFromAbove(plainPhoto(green), 0.3);
    EXPECT_THROW(composite(mesh, atlas, {layer}, baseColour), InvalidModel);
    EXPECT_THROW(coverage(mesh, atlas, layer), InvalidModel);
}

TEST(Composite, GivesPatchesWithoutAreaAColourLikePoints) {
    const TriangleMesh mesh = flatSquare(0.1, 3);
    const PhotoLayer layer = layerFromAbove(plainPhoto(green), 0.3);
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
    PhotoLayer layer = layerFromAbove(plainPhoto(green), 1e-308);
    layer.projector.occlusion = false;
    forEachTexelInside(mesh, atlas, composite(mesh, atlas, {layer}, baseColour),
                       [](auto&, const Colour& colour, std::size_t) { ASSERT_EQ(colour, base); });
}

TEST(Coverage, CountsTexelsAndTriangles) {
    const TriangleMesh mesh = flatSquare(0.1, 4);
    const Atlas atlas = packAtlas(mesh, {512, 1, 2});
    PhotoLayer layer = layerFromAbove(plainPhoto(green), 0.3);
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
    PhotoLayer layer = layerFromAbove(photo, 0.4);
    layer.projector.occlusion = false;
    std::vector<Image> pages = composite(mesh, atlas, {layer}, baseColour);
    EXPECT_LE(seamError(mesh, atlas, pages), 2);
    const Eigen::Vector2d middle = (atlas.corners[100][0] + atlas.corners[100][1]) / 2;
    pages[0].at(int(middle.x()), int(middle.y()))[1] ^= 0x80;
    EXPECT_GT(seamError(mesh, atlas, pages), 10);
}

TEST(Composite, LaysARealPhotoOnARealLiver) {
    ESM_SKIP_WITHOUT(sharedData("meshes/VH_M_Liver.glb"));
    ESM_SKIP_WITHOUT(sharedData("images/lap-liver-gallbladder.jpg"));
    const TriangleMesh mesh = repair(readMeshFile(sharedData("meshes/VH_M_Liver.glb"))).mesh;
    const Atlas atlas = packAtlas(mesh, {1024, 1, 1});
    const Eigen::AlignedBox3d box = boundingBox(mesh.vertices);
    PhotoLayer layer;
    layer.photo = loadPhoto(sharedData("images/lap-liver-gallbladder.jpg"));
    layer.projector.pose.translation() = box.center() + Eigen::Vector3d(0, 0, box.sizes().z());
    layer.projector.width = 0.4;
    layer.projector.height = 0.4 * 1080 / 1920;
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
