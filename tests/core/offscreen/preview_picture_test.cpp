#include "core/offscreen/preview_picture.h"

#include "core/texture/atlas/atlas.h"
#include "tests/core/render/subjects.h"

#include <gtest/gtest.h>

using namespace esm;

namespace {

Project ballProject() {
    Project project;
    project.mesh = std::make_shared<TriangleMesh>(ball(20, 30));
    project.network = edgeNetwork(*project.mesh);
    project.texture.baseColour = {200, 40, 40};
    return project;
}

std::shared_ptr<const std::vector<Image>> greenPages(Project& project) {
    project.atlas = std::make_shared<const Atlas>(packAtlas(*project.mesh, project.texture.atlas));
    const int size = project.atlas->options.size;
    Image page{size, size, {}};
    for (int i = 0; i < size * size; ++i)
        page.pixels.insert(page.pixels.end(), {40, 200, 40, 255});
    return std::make_shared<const std::vector<Image>>(static_cast<std::size_t>(project.atlas->options.pages),
                                                      page);
}

} // namespace

TEST(PreviewPicture, ShowsTheWholeOrganInItsColour) {
    const Image picture = previewPicture(ballProject(), {});
    ASSERT_EQ(picture.width, 512);
    ASSERT_EQ(picture.height, 512);
    const auto isOrgan = [&](int x, int y) { return picture.at(x, y)[0] > picture.at(x, y)[1] + 30; };
    EXPECT_TRUE(isOrgan(256, 256));
    for (int i = 0; i < 512; ++i)
        EXPECT_FALSE(isOrgan(i, 0) || isOrgan(i, 511) || isOrgan(0, i) || isOrgan(511, i)) << i;
}

TEST(PreviewPicture, ShowsTheTexture) {
    Project project = ballProject();
    const Image picture = previewPicture(project, {greenPages(project), nullptr});
    EXPECT_GT(picture.at(256, 256)[1], picture.at(256, 256)[0] + 30);
}
