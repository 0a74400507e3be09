#include "app/editor/workers/moving_photo.h"
#include "core/samples/samples.h"
#include "tests/app/editor_driver.h"

#include <gtest/gtest.h>

using namespace esm;

namespace {

Project withPhotos() {
    Project project = makeSample("ventricle");
    AtlasOptions options;
    options.size = 512;
    project.atlas = std::make_shared<const Atlas>(packAtlas(*project.mesh, options));
    project.texture.atlas = project.atlas->options;
    project.layers.resize(2);
    numberByPlace(project.layers);
    for (TextureLayer& layer : project.layers)
        layer.photo = makeSamplePhoto("serosa");
    return project;
}

void shift(TextureLayer& layer) {
    layer.projector.pose.translation().x() += 0.001;
}

TEST(MovingPhoto, IsTheOneThatDiffersInItsProjectorAlone) {
    const std::vector<TextureLayer> before = withPhotos().layers;
    const auto moved = [&](const std::function<void(std::vector<TextureLayer>&)>& change) {
        std::vector<TextureLayer> now = before;
        change(now);
        return movedLayer(before, now);
    };
    using Layers = std::vector<TextureLayer>;
    EXPECT_EQ(moved([](Layers& now) { shift(now[1]); }), before[1].id);
    EXPECT_FALSE(moved([](Layers&) {}));
    EXPECT_FALSE(moved([](Layers& now) { now[1].opacity = 0.5; }));
    EXPECT_FALSE(moved([](Layers& now) {
        shift(now[1]);
        now[1].opacity = 0.5;
    }));
    EXPECT_FALSE(moved([](Layers& now) {
        shift(now[0]);
        shift(now[1]);
    }));
    EXPECT_FALSE(moved([](Layers& now) { now.pop_back(); }));
}

TEST(MovingPhoto, IsProjectedWhileItMovesAndPaintedWhenItRests) {
    Project project = withPhotos();
    TextureComposer composer;
    MovingPhoto moving(composer);
    moving.follow(project);
    EXPECT_FALSE(moving.projected());
    ESM_EVENTUALLY(!composer.isWorking());
    const TextureComposer::Pages before = composer.composition().pages;
    for (int i = 0; i < 3; ++i) {
        shift(project.layers[1]);
        moving.follow(project);
        ASSERT_TRUE(moving.projected());
        EXPECT_TRUE(moving.projected()->projector == project.layers[1].projector);
        EXPECT_EQ(moving.projected()->photo, pictureOf(project.layers[1]));
        EXPECT_TRUE(moving.isMoving());
    }
    bool rested = false;
    QObject::connect(&moving, &MovingPhoto::rested, [&] { rested = true; });
    ESM_EVENTUALLY(rested && !moving.projected());
    EXPECT_NE(composer.composition().pages, before);
}

/// With strokes and bands, of which only the bands follow the projector.
TEST(MovingPhoto, LeavesWhatIsComposedAroundItAlone) {
    Project project = withPhotos();
    TextureLayer& moved = project.layers[1];
    moved.blending = Blending::MultiBand;
    BrushStroke erased;
    erased.path = {{project.mesh->vertices[0], Eigen::Vector3d::UnitZ()}};
    moved.strokes.push_back(std::make_shared<const BrushStroke>(erased));
    TextureComposer composer;
    MovingPhoto moving(composer);
    moving.follow(project);
    ESM_EVENTUALLY(!composer.isWorking());
    std::vector<TextureComposer::Composed> around;
    QObject::connect(&composer, &TextureComposer::composed, &composer, [&] {
        if (const auto made = composer.composition(); made.moving == moved.id) around.push_back(made);
    });
    // Where nothing came for a while, all is composed anew.
    QObject::connect(&moving, &MovingPhoto::rested, &composer, [&] { around.clear(); });
    ESM_EVENTUALLY((shift(moved), moving.follow(project),
                    around.size() >= 3 && around.front().bands != around.back().bands));
    EXPECT_EQ(around.front().pages, around.back().pages);
}

TEST(MovingPhoto, ThatIsHiddenIsNotProjected) {
    Project project = withPhotos();
    project.layers[1].visible = false;
    TextureComposer composer;
    MovingPhoto moving(composer);
    moving.follow(project);
    shift(project.layers[1]);
    moving.follow(project);
    EXPECT_FALSE(moving.projected());
}

} // namespace
