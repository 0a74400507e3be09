#include "core/texture/photo/photo.h"

#include "core/support/errors.h"
#include "tests/support/shared_data.h"
#include "tests/support/temporary_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>

#include <algorithm>
#include <fstream>
#include <new>
#include <zlib.h>

using namespace esm;
using testing::HasSubstr;

namespace {

Bytes encoded(const std::string& ending, const cv::Mat& picture) {
    Bytes bytes;
    cv::imencode(ending, picture, bytes);
    return bytes;
}

/// Noise compresses badly, so that a cut anywhere takes part of the picture.
cv::Mat noise(int width, int height, int type) {
    cv::Mat picture(height, width, type);
    cv::theRNG().state = 5;
    cv::randu(picture, cv::Scalar::all(0), cv::Scalar::all(CV_MAT_DEPTH(type) == CV_16U ? 65535 : 255));
    return picture;
}

std::array<int, 4> pixelAt(const Photo& photo, int x, int y) {
    const std::uint8_t* pixel = photo.image.at(x, y);
    return {pixel[0], pixel[1], pixel[2], pixel[3]};
}

std::string refusal(const Bytes& bytes) {
    try {
        decodePhoto("liver.jpg", bytes);
    } catch (const FileError& error) {
        return error.what();
    }
    return {};
}

/// A JPEG with an EXIF orientation tag put in after its first marker.
Bytes withOrientation(Bytes jpeg, std::uint8_t orientation) {
    const std::string exif{"\xff\xe1\x00\x22"
                           "Exif\x00\x00"
                           "MM\x00*\x00\x00\x00\x08"
                           "\x00\x01"
                           "\x01\x12\x00\x03\x00\x00\x00\x01\x00\x00\x00\x00"
                           "\x00\x00\x00\x00",
                           36};
    Bytes segment(exif.begin(), exif.end());
    segment[29] = orientation;
    jpeg.insert(jpeg.begin() + 2, segment.begin(), segment.end());
    return jpeg;
}

} // namespace

TEST(Photo, KeepsColoursAlphaAndTheFileItself) {
    const cv::Mat picture = (cv::Mat_<cv::Vec4b>(1, 2) << cv::Vec4b(3, 2, 1, 4), cv::Vec4b(30, 20, 10, 255));
    const Bytes bytes = encoded(".png", picture);
    const auto photo = decodePhoto("a.png", bytes);
    EXPECT_EQ(photo->fileName, "a.png");
    EXPECT_EQ(photo->encoded, bytes);
    ASSERT_EQ(photo->image.width, 2);
    ASSERT_EQ(photo->image.height, 1);
    EXPECT_EQ(pixelAt(*photo, 0, 0), (std::array<int, 4>{1, 2, 3, 4}));
    EXPECT_EQ(pixelAt(*photo, 1, 0), (std::array<int, 4>{10, 20, 30, 255}));
}

TEST(Photo, ReadsGreyAnd16BitPictures) {
    const auto grey = decodePhoto("a.png", encoded(".png", cv::Mat(1, 1, CV_8U, cv::Scalar(77))));
    EXPECT_EQ(pixelAt(*grey, 0, 0), (std::array<int, 4>{77, 77, 77, 255}));
    const cv::Mat deep(1, 1, CV_16UC3, cv::Scalar(257 * 3, 257 * 2, 257 * 255));
    for (const char* ending : {".png", ".tiff"})
        EXPECT_EQ(pixelAt(*decodePhoto("a", encoded(ending, deep)), 0, 0),
                  (std::array<int, 4>{255, 2, 3, 255}));
}

TEST(Photo, TurnsAJpegUpright) {
    cv::Mat picture(32, 64, CV_8UC3, cv::Scalar(0, 0, 0));
    picture.colRange(0, 32).setTo(cv::Scalar(255, 255, 255));
    const auto photo =
        decodePhoto("a.jpg", withOrientation(encoded(".jpg", picture), 6)); // turn clockwise to show
    ASSERT_EQ(photo->image.width, 32);
    ASSERT_EQ(photo->image.height, 64);
    EXPECT_GT(pixelAt(*photo, 16, 8)[0], 240);
    EXPECT_LT(pixelAt(*photo, 16, 56)[0], 15);
}

TEST(Photo, RefusesATruncatedFileWhereverItIsCut) {
    for (const char* ending : {".jpg", ".png", ".bmp", ".tiff"}) {
        const Bytes whole = encoded(ending, noise(64, 48, CV_8UC3));
        EXPECT_EQ(refusal(whole), "") << ending;
        for (std::size_t size = 0; size < whole.size(); size += 1 + size / 50) {
            const std::string message = refusal(Bytes(whole.begin(), whole.begin() + std::ptrdiff_t(size)));
            ASSERT_THAT(message, HasSubstr("liver.jpg: "))
                << ending << " cut to " << size << " of " << whole.size();
        }
    }
}

TEST(Photo, RefusesAJpegCutBehindItsThumbnail) {
    const Bytes thumbnail = encoded(".jpg", noise(16, 16, CV_8UC3));
    Bytes whole = encoded(".jpg", noise(64, 48, CV_8UC3));
    Bytes segment{0xff, 0xe1, std::uint8_t((thumbnail.size() + 2) >> 8), std::uint8_t(thumbnail.size() + 2)};
    segment.insert(segment.end(), thumbnail.begin(), thumbnail.end());
    whole.insert(whole.begin() + 2, segment.begin(), segment.end());
    EXPECT_EQ(refusal(whole), "");
    whole.resize(whole.size() - 200);
    EXPECT_THAT(refusal(whole), HasSubstr("ends before"));
}

TEST(Photo, RefusesADamagedPng) {
    Bytes bytes = encoded(".png", noise(64, 48, CV_8UC3));
    bytes[bytes.size() / 2] ^= 0xff;
    EXPECT_THAT(refusal(bytes), HasSubstr("damaged"));
}

TEST(Photo, DecodersPrintNothing) {
    Bytes strange = encoded(".png", noise(8, 8, CV_8UC4));
    Bytes profile{0, 0, 0, 4, 'i', 'C', 'C', 'P', 'x', 0, 0, 'y'};
    const auto checksum = static_cast<std::uint32_t>(crc32_z(0, profile.data() + 4, profile.size() - 4));
    for (const int shift : {24, 16, 8, 0})
        profile.push_back(std::uint8_t(checksum >> shift));
    constexpr std::ptrdiff_t endOfHeader = 33;
    strange.insert(strange.begin() + endOfHeader, profile.begin(), profile.end());
    Bytes damaged = encoded(".jpg", noise(64, 48, CV_8UC3));
    damaged.erase(damaged.end() - 200, damaged.end() - 2);
    Bytes tiff = encoded(".tiff", noise(64, 48, CV_8UC3));
    std::fill(tiff.begin() + 50, tiff.begin() + 100, std::uint8_t{0xff});
    testing::internal::CaptureStderr();
    EXPECT_EQ(refusal(strange), "");
    refusal(damaged);
    refusal(tiff);
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST(Photo, RefusesWhatIsNoPictureOrTooLarge) {
    EXPECT_THAT(refusal({}), HasSubstr("empty"));
    EXPECT_THAT(refusal({'h', 'e', 'l', 'l', 'o'}), HasSubstr("not a PNG, JPEG, BMP or TIFF"));
    Bytes lying = encoded(".bmp", noise(8, 8, CV_8UC3));
    lying[21] = lying[25] = 0x7f; // claims two thousand million pixels each way
    EXPECT_THAT(refusal(lying), HasSubstr("268 megapixels"));
}

TEST(Photo, ThatMemoryCannotHoldIsNotCalledDamaged) {
    struct NoMemory : cv::MatAllocator {
        cv::UMatData* allocate(int, const int*, int, void*, std::size_t*, cv::AccessFlag,
                               cv::UMatUsageFlags) const override {
            CV_Error(cv::Error::StsNoMem, "no memory");
        }
        bool allocate(cv::UMatData*, cv::AccessFlag, cv::UMatUsageFlags) const override { return false; }
        void deallocate(cv::UMatData*) const override {}
    } full;
    const Bytes bytes = encoded(".png", noise(64, 48, CV_8UC3));
    cv::MatAllocator* const usual = cv::Mat::getDefaultAllocator();
    cv::Mat::setDefaultAllocator(&full);
    EXPECT_THROW(decodePhoto("liver.png", bytes), std::bad_alloc);
    cv::Mat::setDefaultAllocator(usual);
}

TEST(Photo, IsItsOwnPictureUntilItIsPrepared) {
    TextureLayer layer;
    layer.photo = decodePhoto("a.png", encoded(".png", noise(64, 48, CV_8UC3)));
    EXPECT_EQ(pictureOf(layer).get(), &layer.photo->image);
    PhotoPreparation cropped;
    cropped.crop = PhotoCrop{0, 0, 10, 10};
    prepare(layer, cropped);
    EXPECT_EQ(pictureOf(layer)->at(20, 20)[3], 0);
    EXPECT_EQ(TextureLayer(layer).prepared, layer.prepared);
    cropped.crop->width = 65;
    EXPECT_THROW(prepare(layer, cropped), InvalidModel);
    EXPECT_EQ(layer.preparation.crop->width, 10);
    prepare(layer, {});
    EXPECT_EQ(pictureOf(layer).get(), &layer.photo->image);
}

TEST(Photo, NamesTheFileThatCannotBeRead) {
    const TemporaryFolder folder;
    EXPECT_THROW(loadPhoto(folder / "missing.png"), FileError);
    EXPECT_THROW(loadPhoto(folder.path()), FileError);
    std::ofstream(folder / "text.png") << "text";
    try {
        loadPhoto(folder / "text.png");
        FAIL();
    } catch (const FileError& error) {
        EXPECT_THAT(error.what(), HasSubstr((folder / "text.png").string()));
    }
}

TEST(Photo, ReadsEndoscopicPhotos) {
    ESM_SKIP_WITHOUT(sharedData("images/lap-liver-gallbladder.jpg"));
    const auto liver = loadPhoto(sharedData("images/lap-liver-gallbladder.jpg"));
    EXPECT_EQ(liver->fileName, "lap-liver-gallbladder.jpg");
    EXPECT_EQ(liver->image.width, 1920);
    EXPECT_EQ(liver->image.height, 1080);
    EXPECT_EQ(loadPhoto(sharedData("images/hk-colon-lumen.png"))->image.width, 280);
    EXPECT_EQ(loadPhoto(sharedData("images/tex-sofa-head-baked.png"))->image.width, 1024);
}
