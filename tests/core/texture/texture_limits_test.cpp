#include "core/texture/texture_limits.h"

#include "core/texture/atlas/atlas.h"
#include "tests/support/test_surfaces.h"

#include <gmock/gmock.h>

using namespace esm;
using testing::ElementsAre;
using testing::HasSubstr;

TEST(AtlasOptions, AreSoundUpToTheLargestThatMemoryHolds) {
    for (const AtlasOptions options :
         {AtlasOptions{}, AtlasOptions{1, 1, 0}, AtlasOptions{16384, 4, 2}, AtlasOptions{4096, 64, 2}})
        EXPECT_THAT(validate(options), ElementsAre()) << options.size;
    EXPECT_THAT(validate(AtlasOptions{0, 1, 0}),
                ElementsAre("the texture's size must be from 1 to 16384 pixels"));
    EXPECT_THAT(validate(AtlasOptions{16385, 1, 0}), ElementsAre(HasSubstr("size must be from 1 to 16384")));
    EXPECT_THAT(validate(AtlasOptions{1024, 1, 16385}),
                ElementsAre(HasSubstr("gap must be from 0 to 16384")));
    EXPECT_THAT(validate(AtlasOptions{1024, 65, -1}),
                ElementsAre(HasSubstr("pages must be from 1 to 64"), HasSubstr("gap")));
    EXPECT_THAT(validate(AtlasOptions{16384, 5, 2}), ElementsAre(HasSubstr("too large together")));
    EXPECT_THAT(validate(AtlasOptions{16384, 256, 2}), ElementsAre(HasSubstr("pages must be from 1 to 64")));
}

TEST(AtlasLayout, LiesOnItsPages) {
    const TriangleMesh mesh = flatSquare(0.1, 3);
    const Atlas packed = packAtlas(mesh, {128, 2, 2});
    const std::size_t triangles = mesh.triangles.size();
    EXPECT_THAT(validate(packed, triangles), ElementsAre());
    EXPECT_THAT(validate(packed, triangles + 1), ElementsAre(HasSubstr("another surface")));
    for (const double beyond : {-1.0, 129.0, 1e300, -1e300, std::nan("")}) {
        Atlas atlas = packed;
        atlas.corners[5][1].y() = beyond;
        EXPECT_THAT(validate(atlas, triangles), ElementsAre(HasSubstr("(triangle 5)"))) << beyond;
    }
    Atlas atlas = packed;
    atlas.page[7] = 2;
    EXPECT_THAT(validate(atlas, triangles), ElementsAre(HasSubstr("(triangle 7)")));
}
