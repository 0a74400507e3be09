#include "core/texture/layers/surface_beneath.h"

#include "tests/core/texture/layers/painted_pages.h"
#include "tests/support/test_surfaces.h"

#include <tbb/global_control.h>

using namespace esm;
using namespace esm::test;

namespace {

/// The plane of a parallel photo from above, 0.08 m wide.
PhotoPlane planeFromAbove(PhotoSize photo, PhotoSize picture) {
    return {layerFromAbove(nullptr, 0.08).projector, photo, picture};
}

} // namespace

TEST(SurfaceBeneath, ShowsTheSamePhotoFromTheSamePlace) {
    const TriangleMesh mesh = flatSquare(0.1, 4);
    const TextureLayer layer = layerFromAbove(checkerboard(), 0.08);
    const Image seen = surfaceBeneath(mesh, {layer}, baseColour, planeFromAbove({256, 256}, {256, 256}));
    EXPECT_EQ(seen.pixels, layer.photo->image.pixels);
}

TEST(SurfaceBeneath, ShowsTheSamePhotoInPerspective) {
    const TriangleMesh mesh = flatSquare(0.2, 4);
    TextureLayer layer = layerFromAbove(checkerboard(), 0.08);
    layer.projector.kind = ProjectorKind::Perspective;
    layer.projector.pose.translation().z() = 0.1;
    layer.projector.intrinsics = Intrinsics{300, 310, 120, 130};
    const PhotoPlane plane{layer.projector, {256, 256}, {256, 256}};
    const Image seen = surfaceBeneath(mesh, {layer}, baseColour, plane);
    std::size_t far = 0;
    for (std::size_t i = 0; i < seen.pixels.size(); ++i)
        far += std::abs(int(seen.pixels[i]) - int(layer.photo->image.pixels[i])) > 1 ? 1 : 0;
    EXPECT_EQ(far, 0U);
}

TEST(SurfaceBeneath, ReadsALargePhotoAsTheMeanOfWhatAPixelCovers) {
    const TriangleMesh mesh = flatSquare(0.1, 4);
    const auto fine = makePhoto(256, 256, [](int x, int y) {
        return (x + y) % 2 == 0 ? Colour{255, 255, 255, 255} : Colour{0, 0, 0, 255};
    });
    const Image seen =
        surfaceBeneath(mesh, {layerFromAbove(fine, 0.08)}, baseColour, planeFromAbove({256, 256}, {32, 32}));
    ASSERT_EQ(seen.width, 32);
    for (int i = 0; i < 32 * 32; ++i)
        ASSERT_TRUE(isNear(pixelAt(seen, i % 32, i / 32), {128, 128, 128, 255}, 2));
}

TEST(SurfaceBeneath, IsTransparentWhereNoSurfaceTakesColour) {
    TriangleMesh mesh = flatSquare(0.04, 4); // half as wide as the photo
    const PhotoPlane plane = planeFromAbove({64, 64}, {64, 64});
    const Image seen = surfaceBeneath(mesh, {}, baseColour, plane);
    for (int y = 0; y < 64; ++y) {
        for (int x = 0; x < 64; ++x) {
            const bool isMet = std::min({x, y, 63 - x, 63 - y}) >= 16;
            ASSERT_EQ(pixelAt(seen, x, y), isMet ? base : (Colour{0, 0, 0, 0})) << x << " " << y;
        }
    }
    for (Triangle& triangle : mesh.triangles)
        std::swap(triangle[1], triangle[2]);
    const Image away = surfaceBeneath(mesh, {}, baseColour, plane);
    EXPECT_EQ(std::count(away.pixels.begin(), away.pixels.end(), 0), std::ptrdiff_t(away.pixels.size()));
}

TEST(SurfaceBeneath, IsTheSameWithAnyNumberOfThreads) {
    const TriangleMesh mesh = lumpySurface(30, 40);
    const std::vector<TextureLayer> layers{layerFromAbove(checkerboard(), 0.15),
                                           layerFromAbove(checkerboard(), 0.05)};
    const auto seenWith = [&](std::size_t threads) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        return surfaceBeneath(mesh, layers, baseColour, planeFromAbove({200, 200}, {200, 200})).pixels;
    };
    EXPECT_EQ(seenWith(1), seenWith(2));
}
