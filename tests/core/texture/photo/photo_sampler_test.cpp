#include "core/texture/photo/photo_sampler.h"

#include <gtest/gtest.h>

#include <array>

using namespace esm;

namespace {

Image pictureOf(int width, int height, const std::vector<std::array<std::uint8_t, 4>>& colours) {
    Image picture;
    picture.width = width;
    picture.height = height;
    for (const auto& colour : colours)
        picture.pixels.insert(picture.pixels.end(), colour.begin(), colour.end());
    return picture;
}

} // namespace

TEST(PhotoSampler, IsThePixelAtItsCentreAndTheirMeanBetween) {
    const Image picture =
        pictureOf(2, 2, {{0, 0, 0, 255}, {200, 0, 0, 255}, {0, 100, 0, 255}, {200, 100, 0, 255}});
    const PhotoSampler sampler(picture);
    EXPECT_EQ(sampler.at(1.5, 0.5, 0), Eigen::Vector4f(200, 0, 0, 1));
    EXPECT_EQ(sampler.at(1, 1, 0), Eigen::Vector4f(100, 50, 0, 1));
    EXPECT_EQ(sampler.at(0.75, 0.5, 0), Eigen::Vector4f(50, 0, 0, 1));
}

TEST(PhotoSampler, IsClampedAtTheBordersHoweverFar) {
    const Image picture = pictureOf(2, 1, {{10, 20, 30, 255}, {40, 50, 60, 255}});
    const PhotoSampler sampler(picture);
    for (const double far : {0.0, -3.0, -1e300})
        EXPECT_EQ(sampler.at(far, far, 0), Eigen::Vector4f(10, 20, 30, 1)) << far;
    EXPECT_EQ(sampler.at(1e300, 1e300, 0), Eigen::Vector4f(40, 50, 60, 1));
}

TEST(PhotoSampler, WeighsColoursByTheirAlpha) {
    const Image picture = pictureOf(2, 1, {{100, 0, 0, 255}, {0, 255, 0, 0}});
    const Eigen::Vector4f between = PhotoSampler(picture).at(1, 0.5, 0);
    EXPECT_EQ(between, Eigen::Vector4f(100, 0, 0, 0.5F));
}

TEST(PhotoSampler, AveragesWiderTheDeeper) {
    Image picture = pictureOf(1, 1, {{0, 0, 0, 255}});
    picture.width = picture.height = 8;
    picture.pixels.clear();
    for (int i = 0; i < 64; ++i)
        for (const int channel : {(i + i / 8) % 2 * 200, 0, 0, 255})
            picture.pixels.push_back(static_cast<std::uint8_t>(channel));
    const PhotoSampler sampler(picture);
    EXPECT_EQ(sampler.at(0.5, 0.5, 0).x(), 0);
    EXPECT_EQ(sampler.at(0.5, 0.5, 0.5).x(), 50);
    for (const double depth : {1.0, 2.0, 3.0, 99.0})
        EXPECT_EQ(sampler.at(0.5, 0.5, depth).x(), 100) << depth;
}

TEST(PhotoSampler, ReadsOpaquePhotosAsThoseOfWhichOneFarPixelIsNot) {
    Image picture = pictureOf(1, 1, {{0, 0, 0, 255}});
    picture.width = picture.height = 64;
    picture.pixels.clear();
    for (int i = 0; i < 64 * 64; ++i)
        for (const int channel : {i * 37 % 256, i * 101 % 256, i * 59 % 256, 255})
            picture.pixels.push_back(static_cast<std::uint8_t>(channel));
    Image pierced = picture;
    pierced.pixels.back() = 0;
    const PhotoSampler opaque(picture), byAlpha(pierced);
    for (int i = 0; i < 200; ++i) {
        const double x = i % 20 * 1.37, y = i / 10 * 1.19, depth = i % 7 * 0.31;
        const Eigen::Vector4f difference = opaque.at(x, y, depth) - byAlpha.at(x, y, depth);
        ASSERT_LT(difference.cwiseAbs().maxCoeff(), 1e-3F) << i;
    }
}
