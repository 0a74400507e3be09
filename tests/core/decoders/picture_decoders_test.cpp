#include "core/decoders/picture_decoders.h"

#include "core/support/file_io.h"
#include "tests/support/shared_data.h"

#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>

#include <cstring>
#include <filesystem>
#include <stdexcept>

using namespace esm;

namespace {

struct Kind {
    const char* ending;
    int type;                    ///< of OpenCV
    std::vector<int> parameters; ///< for writing
};

constexpr int unpacked = 1; ///< as TIFF numbers it

const std::vector<Kind> kinds{
    {".png", CV_8UC1, {}},
    {".png", CV_8UC3, {}},
    {".png", CV_8UC4, {}},
    {".png", CV_16UC1, {}},
    {".png", CV_16UC3, {}},
    {".png", CV_16UC4, {}},
    {".png", CV_8UC1, {cv::IMWRITE_PNG_BILEVEL, 1}},
    {".jpg", CV_8UC1, {}},
    {".jpg", CV_8UC3, {cv::IMWRITE_JPEG_QUALITY, 90}},
    {".jpg", CV_8UC3, {cv::IMWRITE_JPEG_PROGRESSIVE, 1}},
    {".jpg", CV_8UC3, {cv::IMWRITE_JPEG_QUALITY, 100, cv::IMWRITE_JPEG_RST_INTERVAL, 2}},
    {".bmp", CV_8UC3, {}},
    {".tiff", CV_8UC1, {}},
    {".tiff", CV_8UC3, {}},
    {".tiff", CV_8UC3, {cv::IMWRITE_TIFF_COMPRESSION, unpacked}},
    {".tiff", CV_16UC1, {}},
    {".tiff", CV_16UC3, {}},
};

Bytes noiseAs(const Kind& kind, int width, int height) {
    cv::Mat picture(height, width, kind.type);
    cv::theRNG().state = 7;
    cv::randu(picture, cv::Scalar::all(0), cv::Scalar::all(CV_MAT_DEPTH(kind.type) == CV_16U ? 65536 : 256));
    Bytes encoded;
    cv::imencode(kind.ending, picture, encoded, kind.parameters);
    return encoded;
}

Image decoded(const Bytes& encoded) {
    EXPECT_EQ(isPng(encoded) + isJpeg(encoded) + isBmp(encoded) + isTiff(encoded), 1);
    if (isBmp(encoded)) return decodePlainBmp(encoded).value();
    if (isTiff(encoded)) return decodePlainTiff(encoded).value();
    return isPng(encoded) ? decodePng(encoded) : decodeJpeg(encoded);
}

/// Every pixel as OpenCV's decoder has it, 16 bits rounded.
void expectAsOpenCv(const Bytes& encoded, const std::string& what) {
    const Image image = decoded(encoded);
    cv::Mat expected = cv::imdecode(encoded, isJpeg(encoded) ? cv::IMREAD_COLOR : cv::IMREAD_UNCHANGED);
    if (expected.depth() == CV_16U) expected.convertTo(expected, CV_8U, 255.0 / 65535.0);
    ASSERT_EQ(image.width, expected.cols) << what;
    ASSERT_EQ(image.height, expected.rows) << what;
    const int channels = expected.channels();
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const std::uint8_t *pixel = image.at(x, y), *other = expected.ptr(y, x);
            for (int i = 0; i < 3; ++i)
                ASSERT_EQ(pixel[i], channels == 1 ? other[0] : other[2 - i])
                    << what << " at " << x << ' ' << y;
            ASSERT_EQ(pixel[3], channels == 4 ? other[3] : 255) << what << " at " << x << ' ' << y;
        }
}

} // namespace

TEST(PictureDecoders, AgreeWithOpenCvInEveryPixel) {
    for (std::size_t i = 0; i < kinds.size(); ++i)
        for (const auto& [width, height] : {std::pair{61, 37}, {8, 8}, {1, 1}})
            expectAsOpenCv(noiseAs(kinds[i], width, height), "kind " + std::to_string(i));
}

TEST(PictureDecoders, AgreeWithOpenCvOnPhotos) {
    ESM_SKIP_WITHOUT(sharedData("images"));
    for (const auto& entry : std::filesystem::recursive_directory_iterator(sharedData("images"))) {
        const std::string ending = entry.path().extension().string();
        if (ending == ".png" || ending == ".jpg")
            expectAsOpenCv(readFile(entry.path()), entry.path().string());
    }
}

TEST(PictureDecoders, TakeABmpFromItsTopToo) {
    Bytes bmp = noiseAs({".bmp", CV_8UC3, {}}, 7, 5);
    const Image fromBottom = decodePlainBmp(bmp).value();
    constexpr std::size_t height = 22;
    for (std::size_t i = 0; i < 4; ++i)
        bmp[height + i] = static_cast<std::uint8_t>(~bmp[height + i]);
    bmp[height] = static_cast<std::uint8_t>(bmp[height] + 1); // minus five
    expectAsOpenCv(bmp, "from the top");
    EXPECT_EQ(std::memcmp(decodePlainBmp(bmp)->at(0, 4), fromBottom.at(0, 0), 28), 0);
}

TEST(PictureDecoders, LeaveRareKindsOfBmpToOthers) {
    EXPECT_FALSE(decodePlainBmp(noiseAs({".bmp", CV_8UC1, {}}, 7, 5)));
    EXPECT_FALSE(decodePlainBmp(noiseAs({".bmp", CV_8UC4, {}}, 7, 5)));
    Bytes packed = noiseAs({".bmp", CV_8UC3, {}}, 7, 5);
    packed[30] = 1;
    EXPECT_FALSE(decodePlainBmp(packed));
}

TEST(PictureDecoders, LeaveRareAndDamagedTiffToOthers) {
    EXPECT_FALSE(decodePlainTiff(noiseAs({".tiff", CV_8UC4, {}}, 7, 5)));
    EXPECT_FALSE(decodePlainTiff(noiseAs({".tiff", CV_32FC3, {}}, 7, 5)));
    const Bytes tiff = noiseAs({".tiff", CV_8UC3, {cv::IMWRITE_TIFF_COMPRESSION, unpacked}}, 64, 48);
    for (const std::size_t size : {std::size_t{5}, std::size_t{100}, tiff.size() / 2, tiff.size() - 1})
        EXPECT_FALSE(decodePlainTiff(Bytes(tiff.begin(), tiff.begin() + std::ptrdiff_t(size)))) << size;
}

TEST(PictureDecoders, ThrowOnDamage) {
    const Bytes bmp = noiseAs({".bmp", CV_8UC3, {}}, 64, 48);
    for (const std::size_t size : {std::size_t{10}, std::size_t{54}, bmp.size() - 1})
        EXPECT_THROW(decodePlainBmp(Bytes(bmp.begin(), bmp.begin() + std::ptrdiff_t(size))),
                     std::runtime_error);
    Bytes lying = bmp;
    lying[21] = lying[25] = 0x7f;
    EXPECT_THROW(decodePlainBmp(lying), std::runtime_error);
    const Bytes png = noiseAs(kinds[1], 64, 48);
    for (const std::size_t size : {std::size_t{9}, std::size_t{30}, png.size() / 2})
        EXPECT_THROW(decodePng(Bytes(png.begin(), png.begin() + std::ptrdiff_t(size))), std::runtime_error)
            << size;
    Bytes jpeg = noiseAs(kinds[8], 64, 48);
    jpeg.resize(20);
    EXPECT_THROW(decodeJpeg(jpeg), std::runtime_error);
    EXPECT_THROW(decodeJpeg(Bytes{0xff, 0xd8, 0xff}), std::runtime_error);
}
