#include "core/exchange/charts/drawing.h"

#include <gmock/gmock.h>

using namespace esm;

TEST(Drawing, KeepsItsWordsFromBeingTakenForMarkupInSvg) {
    const Drawing drawing{30, 20, {}, {}, {{{2, 18}, "a < b & c", Drawing::Anchor::Start}}};
    EXPECT_THAT(toSvg(drawing), testing::HasSubstr(">a &lt; b &amp; c</text>"));
}

TEST(Drawing, IsAPictureOfItsSizeOnWhite) {
    const Image picture = toImage({30, 20, {}, {}, {}});
    EXPECT_EQ(picture.width, 30);
    EXPECT_EQ(picture.height, 20);
    EXPECT_THAT(picture.pixels, testing::AllOf(testing::SizeIs(30U * 20 * 4), testing::Each(255)));
}
