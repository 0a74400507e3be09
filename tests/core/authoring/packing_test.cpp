#include "core/authoring/packing.h"

#include "core/samples/samples.h"
#include "core/support/errors.h"

#include <gtest/gtest.h>

using namespace esm;

namespace {

Project unpacked(int size) {
    Project project = makeSample("liver");
    project.atlas = nullptr;
    project.texture.atlas.size = size;
    return project;
}

} // namespace

TEST(Packing, TakesLargerPagesWhereTheSurfaceNeedsThem) {
    Project project = unpacked(64);
    EXPECT_THROW(pack(project), InvalidModel);
    EXPECT_EQ(project.atlas, nullptr);
    packIfNeeded(project);
    ASSERT_TRUE(project.atlas);
    EXPECT_GT(project.texture.atlas.size, 64);
    EXPECT_EQ(project.texture.atlas, project.atlas->options);
    EXPECT_TRUE(validate(project).empty());
}

TEST(Packing, LeavesAnAtlasThatIsThere) {
    Project project = unpacked(1024);
    pack(project);
    const auto atlas = project.atlas;
    project.texture.atlas.size = 512;
    packIfNeeded(project);
    EXPECT_EQ(project.atlas, atlas);
    takeAtlas(project, std::make_shared<const Atlas>());
    EXPECT_EQ(project.atlas, atlas);
    EXPECT_EQ(project.texture.atlas.size, 512);
}

TEST(Packing, SaysWhereNoPageIsLargeEnough) {
    const Project project = unpacked(1024);
    AtlasOptions wide;
    wide.gap = 1000;
    EXPECT_THROW(packFitting(*project.mesh, wide), InvalidModel);
}
