#include "app/editor/workers/highlight_finder.h"

#include "core/samples/samples.h"
#include "tests/support/eventually.h"

#include <gtest/gtest.h>

using namespace esm;

TEST(HighlightFinder, GivesTheMaskOfNoOtherPhoto) {
    HighlightFinder finder;
    const auto photo = makeSamplePhoto("serosa"), other = makeSamplePhoto("serosa");
    EXPECT_TRUE(finder.maskOf(photo).isNull());
    finder.find(photo, {});
    ESM_EVENTUALLY(!finder.maskOf(photo).isNull());
    EXPECT_EQ(finder.maskOf(photo).size(), QSize(photo->image.width, photo->image.height));
    EXPECT_TRUE(finder.maskOf(other).isNull());
    finder.find(other, {});
    ESM_EVENTUALLY(!finder.maskOf(other).isNull());
    EXPECT_TRUE(finder.maskOf(photo).isNull());
}
