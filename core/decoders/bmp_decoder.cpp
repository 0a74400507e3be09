#include "core/decoders/picture_decoders.h"
#include "core/support/byte_order.h"

#include <cstdlib>
#include <limits>
#include <stdexcept>

namespace esm {

namespace {

/// What of a BMP file's header says where its pixels lie and how.
struct BmpHeader {
    std::uint32_t begin = 0; ///< byte of the first row
    std::int32_t width = 0, height = 0;
    std::uint32_t bits = 0; ///< of a pixel
    std::uint32_t compression = 0;
};

BmpHeader headerOf(ByteView encoded) {
    constexpr std::size_t shortest = 54;
    if (encoded.size() < shortest) throw std::runtime_error("cut off");
    const auto number = [&](std::size_t place, std::size_t size) {
        return static_cast<std::uint32_t>(unsignedNumber(&encoded[place], size, ByteOrder::Little));
    };
    constexpr std::uint32_t usualHeader = 40; // later ones are longer, the oldest has numbers of two bytes
    if (number(14, 4) < usualHeader) return {};
    return {number(10, 4), static_cast<std::int32_t>(number(18, 4)), static_cast<std::int32_t>(number(22, 4)),
            number(28, 2), number(30, 4)};
}

} // namespace

bool isBmp(ByteView encoded) {
    return encoded.size() > 2 && encoded[0] == 'B' && encoded[1] == 'M';
}

/// Rows go from the bottom up unless the height is negative. −2³¹ has no absolute value and is refused by
/// name.
std::optional<Image> decodePlainBmp(ByteView encoded) {
    const BmpHeader header = headerOf(encoded);
    if (header.bits != 24 || header.compression != 0) return std::nullopt;
    if (header.width <= 0 || header.height == 0 || header.height == std::numeric_limits<std::int32_t>::min())
        throw std::runtime_error("no pixels");
    Image image{header.width, std::abs(header.height), {}};
    const auto width = static_cast<std::size_t>(image.width), height = static_cast<std::size_t>(image.height);
    const std::size_t rowBytes = (3 * width + 3) / 4 * 4; // rows begin at multiples of four bytes
    if (header.begin > encoded.size() || height > (encoded.size() - header.begin) / rowBytes)
        throw std::runtime_error("cut off");
    image.pixels.resize(4 * width * height);
    for (std::size_t y = 0; y < height; ++y) {
        const std::size_t storedRow = header.height < 0 ? y : height - 1 - y;
        const std::uint8_t* stored = &encoded[header.begin + storedRow * rowBytes];
        std::uint8_t* pixel = &image.pixels[4 * width * y];
        for (std::size_t x = 0; x < width; ++x, stored += 3, pixel += 4) {
            pixel[0] = stored[2];
            pixel[1] = stored[1];
            pixel[2] = stored[0];
            pixel[3] = 255;
        }
    }
    return image;
}

} // namespace esm
