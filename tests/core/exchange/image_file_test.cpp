#include "core/exchange/image_file.h"

#include "core/support/errors.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>

#include <cstring>
#include <limits>
#include <optional>

using namespace esm;

namespace {

template<typename Channel = std::uint8_t> ImageOf<Channel> pattern(int width, int height, bool opaque) {
    constexpr int largest = std::numeric_limits<Channel>::max();
    ImageOf<Channel> image;
    image.width = width;
    image.height = height;
    for (int i = 0; i < width * height; ++i)
        for (const int channel : {7 * i, 1100 * i, 13 * i, opaque ? largest : 1700 * i})
            image.pixels.push_back(static_cast<Channel>(channel));
    return image;
}

/// The data of the first chunk of that name.
std::optional<Bytes> chunk(const Bytes& png, const char* name) {
    for (std::size_t place = 8; place + 12 <= png.size();) {
        const std::size_t length = std::size_t{png[place]} << 24 | std::size_t{png[place + 1]} << 16 |
                                   std::size_t{png[place + 2]} << 8 | png[place + 3];
        const auto data = png.begin() + std::ptrdiff_t(place) + 8;
        if (std::memcmp(&png[place + 4], name, 4) == 0) return Bytes(data, data + std::ptrdiff_t(length));
        place += 12 + length;
    }
    return std::nullopt;
}

template<typename Channel> void expectReadBack(const ImageOf<Channel>& image) {
    const cv::Mat read = cv::imdecode(encodePng(image), cv::IMREAD_UNCHANGED);
    ASSERT_EQ(read.cols, image.width);
    ASSERT_EQ(read.rows, image.height);
    ASSERT_EQ(read.elemSize1(), sizeof(Channel));
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            const Channel* pixel = image.at(x, y);
            const Channel* other = read.ptr<Channel>(y) + x * read.channels();
            const int alpha = read.channels() == 4 ? other[3] : std::numeric_limits<Channel>::max();
            ASSERT_EQ((std::array<int, 4>{pixel[0], pixel[1], pixel[2], pixel[3]}),
                      (std::array<int, 4>{other[2], other[1], other[0], alpha}));
        }
    }
}

} // namespace

TEST(ImageFile, IsReadBackByAnotherReader) {
    expectReadBack(pattern(33, 17, true));
    expectReadBack(pattern(33, 17, false));
    expectReadBack(pattern(1, 1, false));
    expectReadBack(pattern<std::uint16_t>(33, 17, true));
    expectReadBack(pattern<std::uint16_t>(33, 17, false));
}

TEST(ImageFile, NotesColourSpaceAndTexelSize) {
    const Bytes png = encodePng(pattern(4, 4, true), 4000.4);
    EXPECT_EQ(chunk(png, "sRGB"), Bytes{0});
    EXPECT_EQ(chunk(png, "pHYs"), (Bytes{0, 0, 0x0f, 0xa0, 0, 0, 0x0f, 0xa0, 1}));
    EXPECT_EQ(chunk(encodePng(pattern(4, 4, true)), "pHYs"), std::nullopt);
}

TEST(ImageFile, IsTheSameEveryTime) {
    EXPECT_EQ(encodePng(pattern(64, 64, false), 1000), encodePng(pattern(64, 64, false), 1000));
}

TEST(ImageFile, WritesAFileOrSaysWhyNot) {
    const TemporaryFolder folder;
    writePng(pattern(5, 5, true), folder / "a.png");
    EXPECT_EQ(readFile(folder / "a.png"), encodePng(pattern(5, 5, true)));
    EXPECT_THROW(writePng(pattern(5, 5, true), folder / "missing/a.png"), FileError);
    EXPECT_THROW(encodePng(Image()), InvalidModel);
}
