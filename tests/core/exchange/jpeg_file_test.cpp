#include "core/exchange/jpeg_file.h"

#include "core/support/errors.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>

#include <cmath>

using namespace esm;

namespace {

/// A smooth picture, as photos of tissue are.
Image smoothPicture(int width, int height) {
    Image image{width, height, {}};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (const double channel : {200.0 - x, 60.0 + y, 90 + 40 * std::sin(0.1 * (x + y)), 255.0})
                image.pixels.push_back(static_cast<std::uint8_t>(channel));
    return image;
}

/// The largest difference of any channel, as OpenCV reads the file.
int largestDifference(const Image& image, const Bytes& jpeg) {
    const cv::Mat read = cv::imdecode(jpeg, cv::IMREAD_COLOR);
    if (read.cols != image.width || read.rows != image.height) return 256;
    int largest = 0;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            for (int channel = 0; channel < 3; ++channel)
                largest =
                    std::max(largest, std::abs(image.at(x, y)[channel] - read.ptr(y)[3 * x + 2 - channel]));
    return largest;
}

std::string jpegProblem(const Image& image, int quality) {
    try {
        encodeJpeg(image, quality);
    } catch (const InvalidModel& error) {
        return error.what();
    }
    return "stored";
}

} // namespace

TEST(JpegFile, IsReadByAnotherReaderNearlyAsItWas) {
    const Image image = smoothPicture(123, 77);
    EXPECT_LE(largestDifference(image, encodeJpeg(image, 100)), 5);
    EXPECT_LE(largestDifference(image, encodeJpeg(image)), 8);
    EXPECT_LE(largestDifference(smoothPicture(1, 1), encodeJpeg(smoothPicture(1, 1))), 8);
    EXPECT_LT(encodeJpeg(image, 50).size(), encodeJpeg(image).size());
}

/// Colours that are stored half as fine reach over into the texel beside them.
TEST(JpegFile, KeepsColoursAsFineAsBrightness) {
    Image image{16, 16, {}};
    for (int i = 0; i < 256; ++i)
        for (const int channel : {i % 16 < 7 ? 255 : 0, 0, i % 16 < 7 ? 0 : 255, 255})
            image.pixels.push_back(static_cast<std::uint8_t>(channel));
    EXPECT_LE(largestDifference(image, encodeJpeg(image, 100)), 6);
}

TEST(JpegFile, NotesTexelsPerCentimetre) {
    const auto density = [](double texelsPerMetre) {
        const Bytes jpeg = encodeJpeg(smoothPicture(8, 8), 90, texelsPerMetre);
        return std::vector<int>{jpeg[13], jpeg[14] << 8 | jpeg[15], jpeg[16] << 8 | jpeg[17]};
    };
    EXPECT_EQ(density(4020), (std::vector<int>{2, 40, 40}));
    EXPECT_EQ(density(1e9), (std::vector<int>{2, 65535, 65535}));
    EXPECT_EQ(density(0)[0], 0);
}

TEST(JpegFile, IsTheSameEveryTime) {
    EXPECT_EQ(encodeJpeg(smoothPicture(64, 64)), encodeJpeg(smoothPicture(64, 64)));
}

TEST(JpegFile, WhatItCannotHoldIsRefused) {
    using testing::HasSubstr;
    EXPECT_THAT(jpegProblem({}, 92), HasSubstr("without pixels"));
    EXPECT_THAT(jpegProblem(smoothPicture(4, 4), 0), HasSubstr("must be 1 to 100, not 0"));
    EXPECT_THAT(jpegProblem(smoothPicture(4, 4), 101), HasSubstr("must be 1 to 100"));
    EXPECT_THAT(jpegProblem(Image{1, 1, {1, 2, 3, 254}}, 92), HasSubstr("store it as PNG"));
    EXPECT_THAT(jpegProblem(Image{65501, 1, Bytes(std::size_t{4} * 65501, 255)}, 92),
                HasSubstr("larger than 65500"));
}

TEST(JpegFile, EndsWhenCancelled) {
    EXPECT_THROW(encodeJpeg(smoothPicture(8, 8), 92, 0, [](double done) { return done < 0.5; }), Cancelled);
}
