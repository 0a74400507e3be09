#include "core/texture/photo/photo.h"

#include "core/decoding/decoder_process.h"
#include "core/support/errors.h"
#include "core/texture/layers/texture_layer.h"
#include "core/texture/photo/photo_format.h"
#include "tests/support/decode_with.h"
#include "tests/support/sanitized.h"
#include "tests/support/shared_data.h"
#include "tests/support/temporary_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>

#include <algorithm>
#include <atomic>
#include <filesystem>
#include <fstream>
#include <sys/stat.h>
#include <thread>
#include <unistd.h>
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

/// A chunk of a PNG with its length and checksum.
Bytes chunk(const std::string& name, const Bytes& content) {
    Bytes bytes;
    const auto add = [&](std::uint32_t number) {
        for (const int shift : {24, 16, 8, 0})
            bytes.push_back(std::uint8_t(number >> shift));
    };
    add(static_cast<std::uint32_t>(content.size()));
    bytes.insert(bytes.end(), name.begin(), name.end());
    bytes.insert(bytes.end(), content.begin(), content.end());
    add(static_cast<std::uint32_t>(crc32_z(0, bytes.data() + 4, bytes.size() - 4)));
    return bytes;
}

constexpr std::ptrdiff_t endOfPngHeader = 33;

/// A PNG with an EXIF orientation tag put in after its header, in Intel's order of bytes.
Bytes withExif(Bytes png, std::uint8_t orientation) {
    const Bytes exif = chunk("eXIf", {'I', 'I', '*', 0, 8, 0,           0, 0, 1, 0, 0x12, 1, 3,
                                      0,   1,   0,   0, 0, orientation, 0, 0, 0, 0, 0,    0, 0});
    png.insert(png.begin() + endOfPngHeader, exif.begin(), exif.end());
    return png;
}

Bytes numbersOf(std::initializer_list<std::uint32_t> numbers) {
    Bytes bytes;
    for (const std::uint32_t number : numbers)
        for (const int shift : {24, 16, 8, 0})
            bytes.push_back(std::uint8_t(number >> shift));
    return bytes;
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

TEST(Photo, ReadsAPictureOfPrintersInks) {
    // 8 × 8 pixels of red 200, green 60, blue 40 in cyan, magenta, yellow and black, as Adobe writes JPEG.
    const Bytes jpeg{
        0xff, 0xd8, 0xff, 0xee, 0x00, 0x0e, 0x41, 0x64, 0x6f, 0x62, 0x65, 0x00, 0x64, 0x00, 0x00, 0x00, 0x00,
        0x02, 0xff, 0xdb, 0x00, 0x43, 0x00, 0x03, 0x02, 0x02, 0x03, 0x02, 0x02, 0x03, 0x03, 0x03, 0x03, 0x04,
        0x03, 0x03, 0x04, 0x05, 0x08, 0x05, 0x05, 0x04, 0x04, 0x05, 0x0a, 0x07, 0x07, 0x06, 0x08, 0x0c, 0x0a,
        0x0c, 0x0c, 0x0b, 0x0a, 0x0b, 0x0b, 0x0d, 0x0e, 0x12, 0x10, 0x0d, 0x0e, 0x11, 0x0e, 0x0b, 0x0b, 0x10,
        0x16, 0x10, 0x11, 0x13, 0x14, 0x15, 0x15, 0x15, 0x0c, 0x0f, 0x17, 0x18, 0x16, 0x14, 0x18, 0x12, 0x14,
        0x15, 0x14, 0xff, 0xdb, 0x00, 0x43, 0x01, 0x03, 0x04, 0x04, 0x05, 0x04, 0x05, 0x09, 0x05, 0x05, 0x09,
        0x14, 0x0d, 0x0b, 0x0d, 0x14, 0x14, 0x14, 0x14, 0x14, 0x14, 0x14, 0x14, 0x14, 0x14, 0x14, 0x14, 0x14,
        0x14, 0x14, 0x14, 0x14, 0x14, 0x14, 0x14, 0x14, 0x14, 0x14, 0x14, 0x14, 0x14, 0x14, 0x14, 0x14, 0x14,
        0x14, 0x14, 0x14, 0x14, 0x14, 0x14, 0x14, 0x14, 0x14, 0x14, 0x14, 0x14, 0x14, 0x14, 0x14, 0x14, 0x14,
        0x14, 0x14, 0x14, 0xff, 0xc0, 0x00, 0x14, 0x08, 0x00, 0x08, 0x00, 0x08, 0x04, 0x01, 0x11, 0x00, 0x02,
        0x11, 0x01, 0x03, 0x11, 0x01, 0x04, 0x11, 0x00, 0xff, 0xc4, 0x00, 0x15, 0x00, 0x01, 0x01, 0x00, 0x00,
        0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x08, 0xff, 0xc4, 0x00,
        0x14, 0x10, 0x01, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00,
        0x00, 0x00, 0xff, 0xc4, 0x00, 0x15, 0x01, 0x01, 0x01, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00,
        0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x07, 0x08, 0xff, 0xc4, 0x00, 0x14, 0x11, 0x01, 0x00, 0x00, 0x00,
        0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0xff, 0xda, 0x00, 0x0e,
        0x04, 0x01, 0x00, 0x02, 0x11, 0x03, 0x11, 0x04, 0x00, 0x00, 0x3f, 0x00, 0x1c, 0xd0, 0x62, 0xc0, 0x7f,
        0xff, 0xd9,
    };
    const auto [red, green, blue, alpha] = pixelAt(*decodePhoto("a.jpg", jpeg), 4, 4);
    EXPECT_NEAR(red, 200, 4);
    EXPECT_NEAR(green, 60, 4);
    EXPECT_NEAR(blue, 40, 4);
    EXPECT_EQ(alpha, 255);
}

TEST(Photo, TurnsPicturesUprightHoweverTheyWereTaken) {
    // The file's quarters, from its top left corner: red, green / blue, white.
    cv::Mat picture(32, 64, CV_8UC3, cv::Scalar(255, 255, 255));
    picture(cv::Rect(0, 0, 32, 16)).setTo(cv::Scalar(0, 0, 255));
    picture(cv::Rect(32, 0, 32, 16)).setTo(cv::Scalar(0, 255, 0));
    picture(cv::Rect(0, 16, 32, 16)).setTo(cv::Scalar(255, 0, 0));
    // What is seen in the quarters of the upright picture; EXIF 2.3, 4.6.4 A: row 0 and column 0 of the file
    // lie top left, top right, bottom right, bottom left, left top, right top, right bottom, left bottom.
    const std::vector<std::string> seen{"rgbw", "grwb", "wbgr", "bwrg", "rbgw", "brwg", "wgbr", "gwrb"};
    for (const char* ending : {".jpg", ".png"})
        for (std::uint8_t orientation = 1; orientation <= 8; ++orientation) {
            const Bytes bytes = encoded(ending, picture);
            const auto photo =
                decodePhoto("a", ending == std::string(".jpg") ? withOrientation(bytes, orientation)
                                                               : withExif(bytes, orientation));
            const Image& image = photo->image;
            ASSERT_EQ(image.width, orientation < 5 ? 64 : 32) << ending << int(orientation);
            std::string quarters;
            for (const int y : {image.height / 4, 3 * image.height / 4})
                for (const int x : {image.width / 4, 3 * image.width / 4}) {
                    const auto [red, green, blue, alpha] = pixelAt(*photo, x, y);
                    quarters += red > 128 ? (green > 128 ? 'w' : 'r') : green > 128 ? 'g' : 'b';
                    EXPECT_EQ(alpha, 255);
                }
            EXPECT_EQ(quarters, seen[orientation - 1U]) << ending << int(orientation);
        }
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
    const Bytes profile = chunk("iCCP", {'x', 0, 0, 'y'});
    strange.insert(strange.begin() + endOfPngHeader, profile.begin(), profile.end());
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

TEST(Photo, ReadsPalettesWithAndWithoutHoles) {
    const Bytes header{0, 0, 0, 2, 0, 0, 0, 1, 8, 3, 0, 0, 0};
    const Bytes row{0, 0, 1}; // without a filter, the colours 0 and 1
    Bytes packed(64);
    uLongf size = packed.size();
    ASSERT_EQ(compress(packed.data(), &size, row.data(), row.size()), Z_OK);
    packed.resize(size);
    for (const bool hasHole : {false, true}) {
        Bytes png{0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
        std::vector<Bytes> chunks{chunk("IHDR", header), chunk("PLTE", {200, 30, 40, 10, 20, 250})};
        if (hasHole) chunks.push_back(chunk("tRNS", {255, 0}));
        chunks.push_back(chunk("IDAT", packed));
        chunks.push_back(chunk("IEND", {}));
        for (const Bytes& part : chunks)
            png.insert(png.end(), part.begin(), part.end());
        const auto photo = decodePhoto("a.png", png);
        EXPECT_EQ(pixelAt(*photo, 0, 0), (std::array<int, 4>{200, 30, 40, 255}));
        EXPECT_EQ(pixelAt(*photo, 1, 0)[3], hasHole ? 0 : 255);
    }
}

TEST(Photo, IsReadByEveryEndingThatIsOffered) {
    for (const std::string& ending : photoFileEndings()) {
        const Bytes file = encoded("." + ending, noise(12, 9, CV_8UC3));
        EXPECT_EQ(decodePhoto("liver." + ending, file)->image.width, 12) << ending;
    }
}

TEST(Photo, RefusesAnimationsAndImpossibleSizes) {
    Bytes png = encoded(".png", cv::Mat(4, 4, CV_8UC3, cv::Scalar(1, 2, 3)));
    const Bytes animation = chunk("acTL", numbersOf({2, 0}));
    png.insert(png.begin() + endOfPngHeader, animation.begin(), animation.end());
    EXPECT_THAT(refusal(png), HasSubstr("liver.jpg: is animated; save one of its pictures"));
    const std::string gif("GIF89a\x01\x00\x01\x00", 10), webp("RIFF\x10\x00\x00\x00WEBPVP8X", 16);
    for (const std::string& file : {gif, webp})
        EXPECT_THAT(refusal(Bytes(file.begin(), file.end())),
                    HasSubstr("liver.jpg: is not a PNG, JPEG, BMP or TIFF picture; convert it"));
    Bytes huge{0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
    Bytes header = numbersOf({60000, 60000});
    for (const int rest : {8, 2, 0, 0, 0})
        header.push_back(std::uint8_t(rest));
    for (const Bytes& part : {chunk("IHDR", header), chunk("IEND", {})})
        huge.insert(huge.end(), part.begin(), part.end());
    EXPECT_THAT(refusal(huge), HasSubstr("is larger than 268 megapixels (60000 × 60000); scale it down"));
}

TEST(Photo, ThatMemoryCannotHoldIsNotCalledDamaged) {
    if (isSanitized()) GTEST_SKIP() << "addresses are not limited under the address sanitizer";
    const auto large = [](const char* ending, int type) {
        return encoded(ending, cv::Mat(4000, 4000, type, cv::Scalar(1, 2, 3)));
    };
    constexpr std::uint64_t little = 60'000'000, withOpenCv = 280'000'000;
    for (const auto& [picture, memory] : {std::pair{large(".png", CV_8UC3), little},
                                          {large(".tiff", CV_8UC3), little},
                                          {large(".tiff", CV_8UC4), withOpenCv}})
        try {
            decodeApart({"liver", {"picture"}, &picture, {memory, 100'000'000, 60}}, {});
            ADD_FAILURE();
        } catch (const FileError& error) {
            EXPECT_THAT(error.what(), HasSubstr("of memory that it may take"));
        }
}

TEST(Photo, CostsAMessageWhenItsDecoderFails) {
    const TemporaryFolder folder;
    const Bytes whole = encoded(".png", noise(8, 8, CV_8UC3));
    for (const char* failure : {"kill -ABRT $$", "kill -SEGV $$", "exit 1", "printf nonsense", "true",
                                R"(printf '\001esm\010\000\000\000\010\000\000\000short')",
                                R"(printf '\001esm\377\377\377\377\377\377\377\377')"}) {
        std::ofstream(folder / "decoder") << "#!/bin/sh\n" << failure << '\n';
        std::filesystem::permissions(folder / "decoder", std::filesystem::perms::owner_all);
        const DecodeWith standIn(folder / "decoder");
        const std::string message = refusal(whole);
        EXPECT_THAT(message, testing::AllOf(HasSubstr("liver.jpg: "), HasSubstr("cannot be decoded")))
            << failure;
    }
}

TEST(Photo, CanBeCancelled) {
    const TemporaryFolder folder;
    std::ofstream(folder / "decoder") << "#!/bin/sh\nexec sleep 1000\n";
    std::filesystem::permissions(folder / "decoder", std::filesystem::perms::owner_all);
    const DecodeWith standIn(folder / "decoder");
    EXPECT_THROW(decodePhoto("a.png", encoded(".png", noise(8, 8, CV_8UC3)), [](double) { return false; }),
                 Cancelled);
}

TEST(Photo, LeavesStandardErrorWhereItIs) {
    struct stat before {
    }, during{};
    ASSERT_EQ(::fstat(STDERR_FILENO, &before), 0);
    const Bytes large = encoded(".png", noise(1500, 1500, CV_8UC4));
    std::atomic<bool> done = false;
    std::atomic<int> moved = 0;
    std::thread watcher([&] {
        while (!done)
            if (::fstat(STDERR_FILENO, &during) != 0 || during.st_ino != before.st_ino) ++moved;
    });
    for (int i = 0; i < 3; ++i)
        decodePhoto("a.png", large);
    done = true;
    watcher.join();
    EXPECT_EQ(moved, 0) << "what other threads say meanwhile would be lost";
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
