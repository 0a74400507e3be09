#include "core/samples/samples.h"
#include "core/texture/layers/composite.h"
#include "core/texture/layers/page_levels.h"
#include "core/texture/layers/surface_match.h"
#include "core/texture/photo/photo_preparation.h"
#include "tests/support/steady_progress.h"
#include "tests/support/test_surfaces.h"

namespace esm {
namespace {

using Layers = std::vector<TextureLayer>;

constexpr std::array<std::uint8_t, 3> red{200, 60, 50};

/// Two photos, the upper one blended in bands and with a part erased.
Layers twoPhotos() {
    TextureLayer layer;
    layer.photo = makeSamplePhoto("serosa");
    layer.projector.kind = ProjectorKind::Parallel;
    layer.projector.width = 0.2;
    layer.projector.pose.translation() = Eigen::Vector3d(0, 0, 0.5);
    Layers layers{layer, layer};
    layers[1].blending = Blending::MultiBand;
    auto stroke = std::make_shared<BrushStroke>();
    stroke->kind = BrushKind::Erase;
    stroke->path = {{{0, 0, 0.1}, {0, 0, 1}}};
    layers[1].strokes = {stroke};
    return layers;
}

TEST(CompositeProgress, OfComposingIsSteady) {
    const TriangleMesh mesh = lumpySurface(24, 30);
    const Atlas atlas = packAtlas(mesh, {512, 2, 2});
    test::expectGoodProgress(
        [&](const Progress& progress) { composite(mesh, atlas, twoPhotos(), red, progress); });
    test::expectGoodProgress([&](const Progress& progress) { composite(mesh, atlas, {}, red, progress); });
}

TEST(CompositeProgress, OfComposingAnewIsSteady) {
    const TriangleMesh mesh = lumpySurface(24, 30);
    const Atlas atlas = packAtlas(mesh, {512, 2, 2});
    CompositionCache cache;
    const Layers layers = twoPhotos();
    const Composition before{
        layers, red, std::make_shared<const TiledPages>(tiled(composite(mesh, atlas, layers, red, cache)))};
    Layers changed = layers;
    changed[0].opacity = 0.5;
    test::expectGoodProgress(
        [&](const Progress& progress) { recomposite(mesh, atlas, before, changed, red, cache, progress); });
}

TEST(CompositeProgress, OfSmallerPagesIsSteady) {
    const TriangleMesh mesh = lumpySurface(24, 30);
    const Atlas atlas = packAtlas(mesh, {512, 2, 8});
    const TiledPages pages = tiled(composite(mesh, atlas, {}, red));
    test::expectGoodProgress([&](const Progress& progress) { smallerPages(mesh, atlas, pages, progress); });
}

TEST(CompositeProgress, OfPreparingAPhotoIsSteady) {
    PhotoPreparation preparation;
    preparation.highlightThreshold = 200;
    preparation.evenLight = 0.5;
    const Image photo = makeSamplePhoto("serosa")->image;
    preparation.lens = Lens{LensKind::Pinhole, {500, 500, photo.width / 2.0, photo.height / 2.0}, {0.1}};
    test::expectGoodProgress([&](const Progress& progress) { prepared(photo, preparation, progress); });
}

TEST(CompositeProgress, OfMatchingColoursIsSteady) {
    const TriangleMesh mesh = lumpySurface(24, 30);
    const Layers layers = twoPhotos();
    test::expectGoodProgress(
        [&](const Progress& progress) { matchToSurface(mesh, {layers[0]}, red, layers[1], progress); });
}

} // namespace
} // namespace esm
