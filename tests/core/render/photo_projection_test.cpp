#include "core/offscreen/offscreen.h"
#include "core/texture/layers/composite.h"
#include "core/texture/layers/photo_in_motion.h"
#include "tests/core/render/subjects.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace esm;

namespace {

constexpr int side = 480;

/// A smooth photo: what is compared is where it lies, not how finely it is read.
std::shared_ptr<const Photo> smoothPhoto() {
    auto photo = std::make_shared<Photo>();
    Image& image = photo->image;
    image.width = 320;
    image.height = 240;
    image.pixels.resize(4 * 320 * 240);
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            std::uint8_t* pixel = image.at(x, y);
            pixel[0] = static_cast<std::uint8_t>(40 + x / 2);
            pixel[1] = static_cast<std::uint8_t>(230 - y / 2);
            pixel[2] = static_cast<std::uint8_t>(128 + 60 * std::sin(x / 25.0));
            pixel[3] = static_cast<std::uint8_t>(x < 40 ? 128 : 255);
            const bool isLeftOut =
                std::hypot(x - 200, y - 150) < 20; // its colour must not be seen at its rim
            if (isLeftOut) std::fill_n(pixel, 4, std::uint8_t{0});
        }
    return photo;
}

class PhotoInMotion : public testing::Test {
protected:
    PhotoInMotion() : mesh(std::make_shared<const TriangleMesh>(ball(48, 64, 0.35))) {
        AtlasOptions options;
        options.size = 2048;
        options.layout = AtlasLayout::UnfoldedGroups;
        atlas = std::make_shared<const Atlas>(packAtlas(*mesh, options));
        const Eigen::AlignedBox3d box = boundingBox(mesh->vertices);
        size = box.diagonal().norm();
        camera = framedCamera(box, StandardView::Front, 1);
        layer.photo = smoothPhoto();
        layer.blendPixels = 30;
        layer.opacity = 0.9;
    }

    /// From so many degrees beside the camera.
    void place(ProjectorKind kind, double degrees) {
        const Eigen::AlignedBox3d box = boundingBox(mesh->vertices);
        const Eigen::AngleAxisd turn(degrees / 180 * 3.14159265, Eigen::Vector3d::UnitY());
        layer.projector.kind = kind;
        layer.projector.pose.linear() = turn.toRotationMatrix();
        layer.projector.pose.translation() = box.center() + turn * Eigen::Vector3d(0, 0, 0.9 * size);
        layer.projector.width = 0.6 * size;
        layer.projector.height = 0.45 * size;
        layer.projector.fieldOfView = 35;
    }

    RenderScene sceneOf(const std::vector<TextureLayer>& layers) const {
        RenderScene scene;
        scene.mesh = mesh;
        scene.atlas = atlas;
        scene.unlit = true;
        scene.texturePages =
            std::make_shared<const TiledPages>(tiled(composite(*mesh, *atlas, layers, scene.baseColour)));
        return scene;
    }
    Image projected() const {
        RenderScene scene = sceneOf({});
        scene.projectedPhoto = ProjectedPhoto{layer.projector, pictureOf(layer), layer.blendPixels,
                                              layer.opacity, layer.blending};
        scene.projectedPhoto->fadesAtMask = fadesAtMask(layer);
        return renderOffscreen(scene, camera, side, side);
    }
    Image baked() const { return renderOffscreen(sceneOf({layer}), camera, side, side); }
    Image bare() const { return renderOffscreen(sceneOf({}), camera, side, side); }

    std::shared_ptr<const TriangleMesh> mesh;
    std::shared_ptr<const Atlas> atlas;
    double size = 0;
    Camera camera;
    TextureLayer layer;
};

double difference(const Image& a, const Image& b, std::size_t pixel) {
    double most = 0;
    for (std::size_t channel = 0; channel < 3; ++channel)
        most = std::max(
            most, std::abs(double(a.pixels[4 * pixel + channel]) - double(b.pixels[4 * pixel + channel])));
    return most;
}

struct Comparison {
    double covered = 0; ///< pixels that the baked photo changes
    double mean = 0;    ///< difference there and wherever the projected one changes the picture, of 255
    double far = 0;     ///< share of these pixels that differ by more than 24
};

Comparison compared(const Image& projected, const Image& baked, const Image& bare) {
    Comparison found;
    double all = 0;
    for (std::size_t i = 0; i < baked.pixels.size() / 4; ++i) {
        const bool isBaked = difference(baked, bare, i) > 2;
        if (!isBaked && difference(projected, bare, i) <= 2) continue;
        const double off = difference(projected, baked, i);
        found.covered += isBaked ? 1 : 0;
        found.mean += off;
        found.far += off > 24 ? 1 : 0;
        ++all;
    }
    found.mean /= all;
    found.far /= all;
    return found;
}

TEST_F(PhotoInMotion, ShowsWhatIsBaked) {
    for (const ProjectorKind kind : {ProjectorKind::Parallel, ProjectorKind::Perspective})
        for (const double degrees : {0.0, 35.0, 70.0})
            for (const bool falloff : {false, true}) {
                place(kind, degrees);
                layer.projector.falloff = falloff;
                const Comparison found = compared(projected(), baked(), bare());
                const auto where = testing::Message() << int(kind) << ' ' << degrees << ' ' << falloff;
                EXPECT_GT(found.covered, 0.04 * side * side) << where;
                EXPECT_LT(found.mean, 2) << where;
                EXPECT_LT(found.far, 0.02) << where;
            }
}

TEST_F(PhotoInMotion, GoesThroughTheOrganWhereItIsAskedTo) {
    place(ProjectorKind::Parallel, 180);
    EXPECT_EQ(projected().pixels, bare().pixels) << "from behind nothing comes to the front";
    layer.projector.occlusion = false;
    const Comparison found = compared(projected(), baked(), bare());
    EXPECT_GT(found.covered, 0.05 * side * side);
    EXPECT_LT(found.mean, 2);
}

TEST_F(PhotoInMotion, BlendsAsTheLayerDoes) {
    place(ProjectorKind::Perspective, 20);
    const Image hidden = projected();
    for (const Blending blending :
         {Blending::Multiply, Blending::Screen, Blending::Overlay, Blending::Colour}) {
        layer.blending = blending;
        const Comparison found = compared(projected(), baked(), bare());
        EXPECT_GT(found.covered, 0.04 * side * side) << wordOf(blending);
        EXPECT_LT(found.mean, 2) << wordOf(blending);
        EXPECT_LT(found.far, 0.02) << wordOf(blending);
        EXPECT_NE(projected().pixels, hidden.pixels) << wordOf(blending);
    }
}

TEST_F(PhotoInMotion, IsProjectedOnTheOrganAtRest) {
    place(ProjectorKind::Perspective, 0);
    const auto moved = [&](RenderScene scene) {
        scene.nodePositions = mesh->vertices;
        for (Eigen::Vector3d& position : scene.nodePositions)
            position.x() += 0.2 * size;
        return renderOffscreen(scene, camera, side, side);
    };
    RenderScene scene = sceneOf({});
    const Image bareMoved = moved(scene), bakedMoved = moved(sceneOf({layer}));
    scene.projectedPhoto =
        ProjectedPhoto{layer.projector, pictureOf(layer), layer.blendPixels, layer.opacity, Blending::Normal};
    EXPECT_LT(compared(moved(scene), bakedMoved, bareMoved).mean, 2);
}

TEST_F(PhotoInMotion, ShowsWhatStrokesHaveLeft) {
    place(ProjectorKind::Perspective, 20);
    const Image whole = projected();
    BrushStroke erasing;
    const Eigen::AlignedBox3d box = boundingBox(mesh->vertices);
    erasing.radius = 0.12 * size;
    erasing.path = {{box.center() + Eigen::Vector3d(0, 0, 0.5 * box.sizes().z()), Eigen::Vector3d::UnitZ()}};
    layer.strokes = {std::make_shared<const BrushStroke>(erasing)};
    RenderScene scene = sceneOf({});
    CompositionCache cache;
    scene.texturePages = std::make_shared<const TiledPages>(
        maskedPages(*mesh, *atlas, *scene.texturePages, layer.strokes, cache));
    scene.projectedPhoto = ProjectedPhoto{
        layer.projector, pictureOf(layer), layer.blendPixels, layer.opacity, Blending::Normal, true, {}};
    const Image masked = renderOffscreen(scene, camera, side, side);
    EXPECT_LT(compared(masked, baked(), bare()).mean, 2);
    EXPECT_GT(compared(whole, baked(), bare()).mean, 5);
}

TEST_F(PhotoInMotion, IsNearlyWhatBlendingInBandsMakesOfIt) {
    place(ProjectorKind::Perspective, 0);
    TextureLayer under = layer;
    auto green = std::make_shared<Photo>();
    green->image = {1, 1, {40, 180, 90, 255}};
    under.photo = green;
    under.projector.fieldOfView = 80;
    under.blendPixels = 0;
    layer.blending = Blending::MultiBand;
    layer.projector.fieldOfView = 12; // outlines, at which bands end too, lie beside the photo
    layer.opacity = 1;
    const Image beneath = renderOffscreen(sceneOf({under}), camera, side, side);
    const Image blended = renderOffscreen(sceneOf({under, layer}), camera, side, side);
    RenderScene scene = sceneOf({under});
    CompositionCache cache;
    scene.projectedPhoto = ProjectedPhoto{
        layer.projector, pictureOf(layer), borderInMotion(layer), layer.opacity, Blending::Normal, false, {}};
    const double without = compared(renderOffscreen(scene, camera, side, side), blended, beneath).mean;
    scene.projectedPhoto->bands =
        std::make_shared<const Image>(bandsInMotion({*mesh, *atlas, *scene.texturePages}, layer, cache));
    const double with = compared(renderOffscreen(scene, camera, side, side), blended, beneath).mean;
    EXPECT_LT(with, 5);
    EXPECT_GT(without, 4 * with);
}

TEST_F(PhotoInMotion, FadesTowardsItsMaskAsWhenItIsPainted) {
    place(ProjectorKind::Perspective, 0);
    const Image sharp = baked();
    layer.prepared = pictureOf(layer);
    layer.preparation.crop = PhotoCrop{0, 0, 320, 240}; // as if it had left out what is transparent
    for (const bool occlusion : {true, false}) {
        layer.projector.occlusion = occlusion;
        EXPECT_LT(compared(projected(), baked(), bare()).mean, 2) << occlusion;
    }
    EXPECT_GT(compared(projected(), sharp, bare()).mean, 3) << "it ended sharp before";
}

TEST_F(PhotoInMotion, WithoutAPhotoProjectsNothing) {
    RenderScene scene = sceneOf({});
    scene.projectedPhoto = ProjectedPhoto{};
    EXPECT_EQ(renderOffscreen(scene, camera, side, side).pixels, bare().pixels);
}

} // namespace
