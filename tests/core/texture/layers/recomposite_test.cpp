#include "tests/core/texture/layers/painted_pages.h"
#include "tests/support/test_surfaces.h"

using namespace esm;
using namespace esm::test;

namespace {

TextureLayer projected(double x, double width) {
    TextureLayer layer = layerFromAbove(checkerboard(), width);
    layer.projector.pose.translation().x() = x;
    layer.blendPixels = 20;
    return layer;
}

std::shared_ptr<const BrushStroke> stroke(BrushKind kind, const Eigen::Vector3d& place) {
    BrushStroke made;
    made.kind = kind;
    made.radius = 0.02;
    made.colour = {20, 30, 240};
    made.shift = {-0.04, 0.01, 0};
    made.path = {{place, Eigen::Vector3d::UnitZ()}, {{0, 0.02, 0.1}, Eigen::Vector3d::UnitY()}};
    return std::make_shared<const BrushStroke>(made);
}

TextureLayer painted(BrushKind kind) {
    TextureLayer layer;
    layer.strokes = {stroke(kind, {0.02, 0, 0.1})};
    return layer;
}

using Layers = std::vector<TextureLayer>;

/// Every kind of edit, done one after the other.
const std::vector<std::pair<const char*, std::function<void(Layers&)>>> edits{
    {"move", [](Layers& l) { l[0].projector.pose.translation().x() += 0.01; }},
    {"opacity", [](Layers& l) { l[1].opacity = 0.4; }},
    {"hide", [](Layers& l) { l[0].visible = false; }},
    {"show", [](Layers& l) { l[0].visible = true; }},
    {"swap", [](Layers& l) { std::swap(l[0], l[1]); }},
    {"erase",
     [](Layers& l) {
         l[0].strokes.push_back(stroke(BrushKind::Erase, {0, 0, 0.1}));
     }},
    {"restore",
     [](Layers& l) {
         l[0].strokes.push_back(stroke(BrushKind::Restore, {0.01, 0, 0.1}));
     }},
    {"undo", [](Layers& l) { l[0].strokes.pop_back(); }},
    {"paint", [](Layers& l) { l.push_back(painted(BrushKind::Colour)); }},
    {"clone", [](Layers& l) { l.push_back(painted(BrushKind::Clone)); }},
    {"heal", [](Layers& l) { l.push_back(painted(BrushKind::Heal)); }},
    {"heal on",
     [](Layers& l) {
         l[3].strokes.push_back(stroke(BrushKind::Heal, {-0.01, 0.01, 0.1}));
     }},
    {"erase beneath the healing",
     [](Layers& l) {
         l[0].strokes.push_back(stroke(BrushKind::Erase, {0.05, 0, 0.1}));
     }},
    {"heal no more", [](Layers& l) { l.pop_back(); }},
    {"move beneath the clone", [](Layers& l) { l[1].projector.pose.translation().x() -= 0.02; }},
    {"add", [](Layers& l) { l.insert(l.begin() + 1, projected(-0.03, 0.07)); }},
    {"multiply", [](Layers& l) { l[1].blending = Blending::Multiply; }},
    {"screen", [](Layers& l) { l[0].blending = Blending::Screen; }},
    {"overlay", [](Layers& l) { l[1].blending = Blending::Overlay; }},
    {"colour", [](Layers& l) { l[0].blending = Blending::Colour; }},
    {"bands", [](Layers& l) { l[2].blending = Blending::MultiBand; }},
    {"erase beneath the bands",
     [](Layers& l) {
         l[0].strokes.push_back(stroke(BrushKind::Erase, {-0.05, 0, 0.1}));
     }},
    {"erase in the bands",
     [](Layers& l) {
         l[2].strokes.push_back(stroke(BrushKind::Erase, {0, 0, 0.1}));
     }},
    {"blend", [](Layers& l) { l[2].blendPixels = 3; }},
    {"paint on",
     [](Layers& l) {
         l[3].strokes.push_back(stroke(BrushKind::Colour, {-0.02, 0, 0.1}));
     }},
    {"remove", [](Layers& l) { l.erase(l.begin()); }},
    {"rename", [](Layers& l) { l[0].name = "another"; }},
    {"remove all", [](Layers& l) { l.clear(); }},
};

} // namespace

TEST(Recomposite, MakesWhatAWholeCompositionMakesAfterEveryEdit) {
    const TriangleMesh mesh = lumpySurface(24, 30);
    const Atlas atlas = packAtlas(mesh, {512, 2, 2});
    CompositionCache cache;
    Composition composition{{projected(0.02, 0.1), projected(-0.02, 0.08)}, baseColour, nullptr};
    const auto compose = [&](const Layers& layers) {
        auto pages = recomposite(mesh, atlas, composition, layers, baseColour, cache);
        composition = {layers, baseColour, std::make_shared<const TiledPages>(std::move(pages))};
    };
    Layers layers = composition.layers;
    compose(layers);
    for (const auto& [name, edit] : edits) {
        edit(layers);
        compose(layers);
        const std::vector<Image> whole = composite(mesh, atlas, layers, baseColour);
        ASSERT_EQ(composition.pages->size(), whole.size());
        for (std::size_t page = 0; page < whole.size(); ++page)
            ASSERT_EQ((*composition.pages)[page].image().pixels, whole[page].pixels) << name;
    }
}

TEST(Recomposite, LeavesWhatNoChangeReaches) {
    const TriangleMesh mesh = flatSquare(0.1, 20);
    const Atlas atlas = packAtlas(mesh, {512, 1, 2});
    // Pages that no composition makes show what was touched.
    const Image untouched{512, 512, std::vector<std::uint8_t>(4 * 512 * 512, 7)};
    const Layers before{layerFromAbove(plainPhoto(green), 0.3)};
    Layers after = before;
    after[0].strokes = {stroke(BrushKind::Erase, {-0.04, -0.04, 0})};
    BrushStroke small = *after[0].strokes[0];
    small.radius = 0.005;
    small.path.resize(1);
    after[0].strokes[0] = std::make_shared<const BrushStroke>(small);
    CompositionCache cache;
    const auto pages =
        recomposite(mesh, atlas, {before, baseColour, std::make_shared<const TiledPages>(tiled({untouched}))},
                    after, baseColour, cache);
    std::size_t touched = 0;
    forEachTexelInside(mesh, atlas, {pages[0].image()},
                       [&](const Eigen::Vector3d& point, const Colour& colour, auto) {
                           const bool isTouched = colour != Colour{7, 7, 7, 7};
                           touched += isTouched ? 1 : 0;
                           if (isTouched) {
                               ASSERT_LT((point - small.path[0].place).norm(), 0.02);
                           }
                       });
    EXPECT_GT(touched, 100U);
}

TEST(Recomposite, SharesTheTilesInWhichNothingChanged) {
    const TriangleMesh mesh = lumpySurface(24, 30);
    const Atlas atlas = packAtlas(mesh, {1024, 1, 2});
    CompositionCache cache;
    const Layers first{projected(0.02, 0.1)};
    Layers layers = first;
    const auto before =
        std::make_shared<const TiledPages>(recomposite(mesh, atlas, {}, layers, baseColour, cache));
    BrushStroke dab = *stroke(BrushKind::Erase, {0, 0, 0.1});
    dab.radius = 0.004;
    dab.path.resize(1);
    layers[0].strokes = {std::make_shared<const BrushStroke>(dab)};
    const TiledPages after = recomposite(mesh, atlas, {first, baseColour, before}, layers, baseColour, cache);
    int shared = 0;
    for (int row = 0; row < after[0].rows(); ++row)
        for (int column = 0; column < after[0].columns(); ++column)
            shared += after[0].sharesTile(before->front(), column, row) ? 1 : 0;
    EXPECT_GT(shared, after[0].rows() * after[0].columns() / 2);
    EXPECT_LT(shared, after[0].rows() * after[0].columns());
}

TEST(Recomposite, ComposesAnewWithoutPagesOrOverAnotherColour) {
    const TriangleMesh mesh = flatSquare(0.1, 3);
    const Atlas atlas = packAtlas(mesh, {128, 1, 2});
    const Layers layers{layerFromAbove(plainPhoto(green), 0.05)};
    const std::vector<Image> whole = composite(mesh, atlas, layers, {1, 2, 3});
    CompositionCache cache;
    const auto other = std::make_shared<const TiledPages>(tiled(composite(mesh, atlas, layers, baseColour)));
    for (const Composition& before : {Composition{}, Composition{layers, baseColour, other}})
        EXPECT_EQ(recomposite(mesh, atlas, before, layers, {1, 2, 3}, cache)[0].image().pixels,
                  whole[0].pixels);
}

TEST(Recomposite, UsesNothingOfAnAtlasThatWasPackedAnew) {
    const TriangleMesh mesh = lumpySurface(12, 16);
    const Layers layers{projected(0.02, 0.1), projected(-0.02, 0.08)};
    CompositionCache cache;
    for (const AtlasOptions& options :
         {AtlasOptions{256, 1, 2}, AtlasOptions{256, 2, 2}, AtlasOptions{256, 2, 4}, AtlasOptions{512, 1, 2},
          AtlasOptions{512, 1, 2, AtlasLayout::Rows}}) {
        const Atlas atlas = packAtlas(mesh, options);
        const std::vector<Image> kept = composite(mesh, atlas, layers, baseColour, cache);
        const std::vector<Image> fresh = composite(mesh, atlas, layers, baseColour);
        for (std::size_t page = 0; page < fresh.size(); ++page)
            ASSERT_EQ(kept[page].pixels, fresh[page].pixels);
    }
}
