#include "core/samples/samples.h"

#include "core/support/errors.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

using namespace esm;

namespace {

Eigen::Vector4d meanOf(const Image& image, int left, int top, int width, int height) {
    Eigen::Vector4d sum = Eigen::Vector4d::Zero();
    for (int y = top; y < top + height; ++y)
        for (int x = left; x < left + width; ++x)
            for (int channel = 0; channel < 4; ++channel)
                sum[channel] += image.at(x, y)[channel];
    return sum / (double(width) * height);
}

} // namespace

TEST(SamplePhotos, HaveTheirNames) {
    EXPECT_THAT(samplePhotoNames(), testing::ElementsAre("vessels", "serosa", "lesion"));
    try {
        makeSamplePhoto("bone");
        FAIL();
    } catch (const InvalidModel& error) {
        for (const std::string& name : samplePhotoNames())
            EXPECT_THAT(error.what(), testing::HasSubstr(name));
    }
}

TEST(SamplePhotos, LookLikeTissueAndFadeOutAtTheirBorder) {
    for (const std::string& name : samplePhotoNames()) {
        const auto photo = makeSamplePhoto(name);
        ASSERT_EQ(photo->image.width, 512) << name;
        ASSERT_EQ(photo->image.height, 512) << name;
        const Eigen::Vector4d middle = meanOf(photo->image, 206, 206, 100, 100);
        EXPECT_GT(middle.x(), 1.15 * middle.y()) << name << " is reddish";
        EXPECT_GT(middle.w(), 250) << name << " is opaque in its middle";
        for (const int corner : {0, 504})
            EXPECT_LT(meanOf(photo->image, corner, corner, 8, 8).w(), 10)
                << name << " is transparent in its corners";
    }
}

TEST(SamplePhotos, AreTheSameInTheirFileAndEveryTime) {
    for (const std::string& name : samplePhotoNames()) {
        const auto photo = makeSamplePhoto(name);
        EXPECT_EQ(decodePhoto(photo->fileName, photo->encoded)->image.pixels, photo->image.pixels) << name;
        EXPECT_EQ(makeSamplePhoto(name)->encoded, photo->encoded) << name;
    }
}
