#include "core/texture/layers/covering_layer.h"

#include <gtest/gtest.h>

namespace esm {
namespace {

/// Layers over a square from −1 to 1 m in the plane z = 0, lit by projectors that look down on it.
class CoveringLayer : public testing::Test {
protected:
    CoveringLayer() {
        layers.push_back(photoLayer(1, "lower"));
        layers.push_back(photoLayer(2, "upper"));
    }
    static TextureLayer photoLayer(std::uint32_t number, const char* name) {
        TextureLayer layer;
        layer.id = {number};
        layer.name = name;
        auto photo = std::make_shared<Photo>();
        photo->image = {100, 100, std::vector<std::uint8_t>(4 * 100 * 100, 255)};
        layer.photo = photo;
        layer.blendPixels = 10;
        layer.projector.width = layer.projector.height = 1;
        layer.projector.pose.translation() = Eigen::Vector3d(0, 0, 1);
        return layer;
    }
    std::string covering(double x, double y = 0) const {
        const TextureLayer* above = coveringLayer(layers, {1}, {{x, y, 0}, Eigen::Vector3d::UnitZ()},
                                                  SurfaceQuery(positions, triangles));
        return above ? above->name : "";
    }
    TextureLayer& upper() { return layers[1]; }

    std::vector<TextureLayer> layers;
    std::vector<Eigen::Vector3d> positions{{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
    std::vector<Triangle> triangles{{0, 1, 2}, {0, 2, 3}};
};

TEST_F(CoveringLayer, IsAPhotoWhereItLiesInFull) {
    EXPECT_EQ(covering(0), "upper");
    EXPECT_EQ(covering(0.3), "upper");
    EXPECT_EQ(covering(0.45), "") << "it fades at its border";
    EXPECT_EQ(covering(0.7), "") << "it does not reach so far";
    EXPECT_EQ(
        coveringLayer(layers, {2}, {{0, 0, 0}, Eigen::Vector3d::UnitZ()}, SurfaceQuery(positions, triangles)),
        nullptr)
        << "nothing lies above the topmost";
}

TEST_F(CoveringLayer, IsNoneThatShowsWhatLiesBeneath) {
    upper().opacity = 0.9;
    EXPECT_EQ(covering(0), "");
    upper().opacity = 1;
    for (const Blending blending :
         {Blending::Multiply, Blending::Screen, Blending::Overlay, Blending::Colour}) {
        upper().blending = blending;
        EXPECT_EQ(covering(0), "") << wordOf(blending);
    }
    upper().blending = Blending::Normal;
    upper().visible = false;
    EXPECT_EQ(covering(0), "");
}

TEST_F(CoveringLayer, IsNoneWhereItsPhotoOrMaskHasNothing) {
    auto holed = std::make_shared<Image>(upper().photo->image);
    holed->at(50, 50)[3] = 0;
    upper().prepared = std::shared_ptr<const Image>(holed);
    EXPECT_EQ(covering(0.005, -0.005), "");
    EXPECT_EQ(covering(0.2), "upper");
    auto erased = std::make_shared<BrushStroke>();
    erased->radius = 0.1;
    erased->path = {{{0.2, 0, 0}, Eigen::Vector3d::UnitZ()}};
    upper().strokes.emplace_back(erased);
    EXPECT_EQ(covering(0.2), "");
}

TEST_F(CoveringLayer, IsNoneWhoseProjectorDoesNotSeeThePoint) {
    const auto add = [&](double z) {
        const auto first = static_cast<std::uint32_t>(positions.size());
        positions.insert(positions.end(), {{-0.1, -0.1, z}, {0.1, -0.1, z}, {0, 0.1, z}});
        triangles.push_back({first, first + 1, first + 2});
    };
    add(0.5);
    EXPECT_EQ(covering(0), "");
    EXPECT_EQ(covering(0.3), "upper");
    upper().projector.occlusion = false;
    EXPECT_EQ(covering(0), "upper");
}

TEST_F(CoveringLayer, IsPaintWhereItIsLaid) {
    upper().photo = nullptr;
    auto paint = std::make_shared<BrushStroke>();
    paint->kind = BrushKind::Colour;
    paint->radius = 0.1;
    paint->path = {{{0, 0, 0}, Eigen::Vector3d::UnitZ()}};
    auto restore = std::make_shared<BrushStroke>(*paint);
    restore->kind = BrushKind::Restore;
    restore->radius = 0.5;
    upper().strokes = {paint, restore};
    EXPECT_EQ(covering(0), "upper");
    EXPECT_EQ(covering(0.3), "") << "restoring lays no paint";
}

} // namespace
} // namespace esm
