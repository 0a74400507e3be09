#include "app/editor/workers/texture_composer.h"
#include "core/samples/samples.h"
#include "tests/app/editor_driver.h"

#include <gtest/gtest.h>

using namespace esm;

namespace {

Project photographed(int pageSize) {
    Project project = makeSample("ventricle");
    project.atlas = std::make_shared<const Atlas>(packAtlas(*project.mesh, {pageSize, 1, 2}));
    TextureLayer layer;
    layer.photo = makeSamplePhoto("serosa");
    project.layers = {layer};
    return project;
}

} // namespace

TEST(TextureComposer, WorksUntilTheLastRequestIsDone) {
    Project project = photographed(1024);
    TextureComposer composer;
    EXPECT_FALSE(composer.isWorking());
    int composed = 0;
    bool pagesAreThere = false;
    QObject::connect(&composer, &TextureComposer::composed, &composer, [&] {
        ++composed;
        pagesAreThere = composer.composition().pages != nullptr;
    });
    for (int request = 0; request < 5; ++request)
        composer.compose(project);
    ESM_EVENTUALLY(composed > 0 && !composer.isWorking());
    EXPECT_TRUE(pagesAreThere);
    project.layers.clear();
    composer.compose(project);
    ESM_EVENTUALLY(!composer.isWorking());
    EXPECT_EQ(composer.composition().pages, nullptr) << "nothing is left to compose";
}

TEST(TextureComposer, ShowsAfterEveryEditWhatAWholeCompositionShows) {
    Project project = photographed(512);
    project.layers.front().projector.pose.translation().z() = 1;
    project.layers.push_back(project.layers.front());
    TextureComposer composer;
    const auto expectWhole = [&] {
        composer.compose(project);
        ESM_EVENTUALLY(!composer.isWorking());
        const TextureComposer::Composed composed = composer.composition();
        ASSERT_TRUE(composed.pages);
        const auto whole =
            composite(*project.mesh, *project.atlas, project.layers, project.texture.baseColour);
        EXPECT_EQ(composed.pages->front().image().pixels, whole.front().pixels);
    };
    expectWhole();
    project.layers[1].projector.pose.translation().x() = 0.02;
    expectWhole();
    project.atlas = std::make_shared<const Atlas>(packAtlas(*project.mesh, {512, 1, 4}));
    expectWhole();
    project.texture.baseColour = {1, 2, 3};
    expectWhole();
}

TEST(TextureComposer, GivesPagesThatBelongTogetherWhileItWorks) {
    Project project = makeSample("ventricle");
    TextureLayer layer;
    layer.photo = makeSamplePhoto("serosa");
    project.layers = {layer};
    std::vector<std::shared_ptr<const Atlas>> atlases;
    for (const int size : {512, 1024})
        atlases.push_back(std::make_shared<const Atlas>(packAtlas(*project.mesh, {size, 1, 4})));
    TextureComposer composer;
    for (std::size_t round = 0; round < 4; ++round) {
        project.atlas = atlases[round % 2];
        composer.compose(project);
        // Before the worker is done, and at the moment at which it is.
        for (bool goesOn = true; goesOn;) {
            goesOn = composer.isWorking();
            const TextureComposer::Composed composed = composer.composition();
            if (!composed.pages) continue;
            const TiledImage& page = composed.pages->front();
            ASSERT_EQ(page.width(), composed.atlas->options.size);
            ASSERT_EQ(composed.smallerPages->front().front().width(), page.width() / 2);
        }
        EXPECT_EQ(composer.composition().atlas, project.atlas);
    }
}

TEST(TextureComposer, HasNothingButTheReasonWhereItFails) {
    Project project = photographed(512);
    TextureComposer composer;
    composer.compose(project);
    ESM_EVENTUALLY(!composer.isWorking());
    EXPECT_EQ(composer.composition().failure, "");
    auto broken = std::make_shared<Atlas>(*project.atlas);
    broken->page.assign(broken->page.size(), 999);
    project.atlas = broken;
    composer.compose(project);
    ESM_EVENTUALLY(!composer.isWorking());
    const TextureComposer::Composed composed = composer.composition();
    EXPECT_NE(composed.failure, "");
    EXPECT_EQ(composed.pages, nullptr);
    EXPECT_EQ(composed.atlas, nullptr);
}

TEST(TextureComposer, StopsWhatIsTakenBack) {
    Project project = photographed(4096);
    TextureComposer composer;
    int composed = 0;
    QObject::connect(&composer, &TextureComposer::composed, &composer, [&] { ++composed; });
    composer.compose(project);
    ESM_EVENTUALLY(!composer.isWorking() && composed == 1);
    EXPECT_EQ(composer.progress(), 1);
    const Project before = project;
    const TextureComposer::Pages pages = composer.composition().pages;
    project.texture.baseColour = {1, 2, 3};
    composer.compose(project);
    ESM_EVENTUALLY(composer.progress() > 0 && composer.progress() < 1);
    composer.compose(before);
    ESM_EVENTUALLY(!composer.isWorking() && composed > 1);
    QCoreApplication::processEvents();
    EXPECT_EQ(composed, 2) << "nobody waits for what was taken back";
    EXPECT_EQ(composer.composition().pages->front().image().pixels, pages->front().image().pixels);
}
