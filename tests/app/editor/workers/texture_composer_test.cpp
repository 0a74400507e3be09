#include "app/editor/workers/texture_composer.h"
#include "core/samples/samples.h"
#include "tests/app/editor_driver.h"

#include <gtest/gtest.h>

using namespace esm;

TEST(TextureComposer, WorksUntilTheLastRequestIsDone) {
    Project project = makeSample("ventricle");
    project.atlas = std::make_shared<const Atlas>(packAtlas(*project.mesh, {1024, 1, 2}));
    TextureLayer layer;
    layer.photo = makeSamplePhoto("serosa");
    project.layers = {layer};
    TextureComposer composer;
    EXPECT_FALSE(composer.isWorking());
    int composed = 0;
    bool pagesAreThere = false;
    QObject::connect(&composer, &TextureComposer::composed, &composer, [&] {
        ++composed;
        pagesAreThere = composer.pages() != nullptr;
    });
    for (int request = 0; request < 5; ++request)
        composer.compose(project);
    ESM_EVENTUALLY(composed > 0 && !composer.isWorking());
    EXPECT_TRUE(pagesAreThere);
    project.layers.clear();
    composer.compose(project);
    ESM_EVENTUALLY(!composer.isWorking());
    EXPECT_EQ(composer.pages(), nullptr) << "nothing is left to compose";
}

TEST(TextureComposer, ShowsAfterEveryEditWhatAWholeCompositionShows) {
    Project project = makeSample("ventricle");
    project.atlas = std::make_shared<const Atlas>(packAtlas(*project.mesh, {512, 1, 2}));
    TextureLayer layer;
    layer.photo = makeSamplePhoto("serosa");
    layer.projector.pose.translation().z() = 1;
    project.layers = {layer, layer};
    TextureComposer composer;
    const auto expectWhole = [&] {
        composer.compose(project);
        ESM_EVENTUALLY(!composer.isWorking());
        ASSERT_TRUE(composer.pages());
        const auto whole =
            composite(*project.mesh, *project.atlas, project.layers, project.texture.baseColour);
        EXPECT_EQ(composer.pages()->front().pixels, whole.front().pixels);
    };
    expectWhole();
    project.layers[1].projector.pose.translation().x() = 0.02;
    expectWhole();
    project.atlas = std::make_shared<const Atlas>(packAtlas(*project.mesh, {512, 1, 4}));
    expectWhole();
    project.texture.baseColour = {1, 2, 3};
    expectWhole();
}
