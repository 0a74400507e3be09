#include "core/texture/maps/finish_layers.h"
#include "tests/core/texture/layers/painted_pages.h"

#include <gmock/gmock.h>

using namespace esm;
using namespace esm::test;

namespace {

TextureLayer shiningLayer(double wetness) {
    TextureLayer layer = layerFromAbove(checkerboard(), 0.1);
    layer.finish.emplace();
    layer.finish->surface = {0.25, wetness};
    return layer;
}

FinishLayers lendingOf(const std::vector<TextureLayer>& layers) {
    FinishPictures pictures;
    return finishLayers(layers, SurfaceFinish{0.6, 0}, pictures);
}

} // namespace

TEST(FinishLayers, AreThoseThatShowAndHaveAFinish) {
    TextureLayer hidden = shiningLayer(1), plain = shiningLayer(1);
    hidden.visible = false;
    plain.finish.reset();
    EXPECT_FALSE(hasFinish({hidden, plain}, std::nullopt));
    EXPECT_TRUE(hasFinish({hidden, plain}, SurfaceFinish{}));
    EXPECT_TRUE(hasFinish({hidden, plain, shiningLayer(1)}, std::nullopt));
    EXPECT_EQ(lendingOf({hidden, plain, shiningLayer(1)}).layers.size(), 1U);
}

TEST(FinishLayers, LendTheirFinishWithoutTheirColour) {
    TextureLayer layer = shiningLayer(1);
    layer.blending = Blending::Multiply;
    layer.finish->hidesColour = true;
    EXPECT_FALSE(isShown(layer));
    const FinishLayers lending = lendingOf({layer});
    ASSERT_EQ(lending.layers.size(), 1U);
    EXPECT_TRUE(isShown(lending.layers[0]));
    EXPECT_EQ(lending.layers[0].blending, Blending::Normal);
    EXPECT_EQ(pixelAt(*pictureOf(lending.layers[0]), 40, 40), (Colour{255, 64, 128, 255}));
}

TEST(FinishLayers, PaintTheirFinishWhateverColourIsPainted) {
    TextureLayer layer;
    BrushStroke stroke;
    stroke.path = {{{0, 0, 0}, {0, 0, 1}}};
    for (const BrushKind kind : {BrushKind::Colour, BrushKind::Clone, BrushKind::Erase}) {
        stroke.kind = kind;
        layer.strokes.push_back(std::make_shared<const BrushStroke>(stroke));
    }
    layer.finish = LayerFinish{{1, 0.2}, 0, 0, false};
    const BrushStrokes painted = lendingOf({layer}).layers.at(0).strokes;
    for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_EQ(painted[i]->kind, BrushKind::Colour);
        EXPECT_EQ(painted[i]->colour, (FinishColour{51, 255, 128}));
    }
    EXPECT_EQ(*painted[2], stroke);
}

TEST(FinishLayers, MakeEachPictureOnce) {
    FinishPictures pictures;
    std::vector<TextureLayer> layers{shiningLayer(1), shiningLayer(0.5)};
    layers[0].id = LayerId{1};
    layers[1].id = LayerId{2};
    const FinishLayers first = finishLayers(layers, std::nullopt, pictures);
    const FinishLayers again = finishLayers(layers, std::nullopt, pictures);
    for (std::size_t i = 0; i < 2; ++i)
        EXPECT_EQ(pictureOf(first.layers[i]), pictureOf(again.layers[i]));
    EXPECT_NE(pictureOf(first.layers[0]), pictureOf(first.layers[1]));
}

TEST(FinishLayers, AreTheSameWhateverFinishThePhotoHadBefore) {
    FinishPictures pictures;
    for (const auto& [wet, relief] :
         std::vector<std::pair<double, double>>{{1, 0.001}, {0, 0.001}, {0.5, 0}, {0.5, 0.002}}) {
        TextureLayer layer = shiningLayer(0.2);
        layer.finish->wetAtHighlights = wet;
        layer.finish->relief = relief;
        const FinishLayers next = finishLayers({layer}, std::nullopt, pictures);
        EXPECT_EQ(pictureOf(next.layers[0])->pixels, pictureOf(lendingOf({layer}).layers[0])->pixels)
            << wet << " " << relief;
    }
}

TEST(FinishLayers, WarnOfWhatHasNoEffect) {
    TextureLayer plain = shiningLayer(1);
    plain.photo = plainPhoto({100, 50, 40, 255});
    EXPECT_THAT(finishWarnings(plain), testing::IsEmpty());
    plain.finish->relief = 0.001;
    EXPECT_THAT(finishWarnings(plain), testing::ElementsAre(testing::HasSubstr("of one colour")));
    TextureLayer painted;
    painted.finish = LayerFinish{{}, 0.5, 0, false};
    EXPECT_THAT(finishWarnings(painted), testing::ElementsAre(testing::HasSubstr("from a photo")));
}
