#include "core/decoders/picture_decoders.h"

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <limits>
#include <memory>

#include <tiffio.h>

namespace esm {

namespace {

/// A file in memory, as libtiff asks for the parts of one.
struct TiffSource {
    ByteView encoded;
    std::uint64_t place = 0;
};

tmsize_t readPart(thandle_t handle, void* data, tmsize_t size) {
    TiffSource& source = *static_cast<TiffSource*>(handle);
    if (size < 0 || source.place > source.encoded.size()) return -1;
    const std::uint64_t count =
        std::min(static_cast<std::uint64_t>(size), source.encoded.size() - source.place);
    if (count > 0) std::memcpy(data, source.encoded.data() + source.place, count);
    source.place += count;
    return static_cast<tmsize_t>(count);
}

tmsize_t refuseToWrite(thandle_t, void*, tmsize_t) {
    return -1;
}

/// A place beyond the end is kept as it is, and reading from there fails: libtiff seeks where damaged
/// directories point.
toff_t moveTo(thandle_t handle, toff_t offset, int from) {
    TiffSource& source = *static_cast<TiffSource*>(handle);
    const toff_t origin = from == SEEK_SET ? 0 : from == SEEK_CUR ? source.place : source.encoded.size();
    return source.place = origin + offset;
}

int keepOpen(thandle_t) {
    return 0;
}

toff_t sizeOf(thandle_t handle) {
    return static_cast<TiffSource*>(handle)->encoded.size();
}

using TiffFile = std::unique_ptr<TIFF, decltype(&TIFFClose)>;

TiffFile openTiff(TiffSource& source) {
    TIFFSetErrorHandler(nullptr);
    TIFFSetWarningHandler(nullptr);
    return {TIFFClientOpen("picture", "rm", &source, readPart, refuseToWrite, moveTo, keepOpen, sizeOf,
                           nullptr, nullptr),
            TIFFClose};
}

template<typename Number> Number numberAt(TIFF* file, std::uint32_t tag) {
    Number number{};
    TIFFGetFieldDefaulted(file, tag, &number);
    return number;
}

struct TiffLayout {
    std::uint32_t width, height;
    std::uint16_t bits;     ///< of a channel
    std::uint16_t channels; ///< 1 for grey, 3 for red, green and blue
};

/// None where the picture is stored in a rare way: in tiles, planes, inks or indices, with alpha or turned.
std::optional<TiffLayout> plainLayoutOf(TIFF* file) {
    const TiffLayout layout{numberAt<std::uint32_t>(file, TIFFTAG_IMAGEWIDTH),
                            numberAt<std::uint32_t>(file, TIFFTAG_IMAGELENGTH),
                            numberAt<std::uint16_t>(file, TIFFTAG_BITSPERSAMPLE),
                            numberAt<std::uint16_t>(file, TIFFTAG_SAMPLESPERPIXEL)};
    const auto colours = numberAt<std::uint16_t>(file, TIFFTAG_PHOTOMETRIC);
    const bool isColoured = layout.channels == 3 && colours == PHOTOMETRIC_RGB;
    const bool isGrey = layout.channels == 1 && colours == PHOTOMETRIC_MINISBLACK;
    constexpr std::uint32_t most = std::numeric_limits<int>::max();
    const bool isPlain =
        !TIFFIsTiled(file) && numberAt<std::uint16_t>(file, TIFFTAG_PLANARCONFIG) == PLANARCONFIG_CONTIG &&
        numberAt<std::uint16_t>(file, TIFFTAG_ORIENTATION) == ORIENTATION_TOPLEFT &&
        numberAt<std::uint16_t>(file, TIFFTAG_SAMPLEFORMAT) == SAMPLEFORMAT_UINT &&
        (layout.bits == 8 || layout.bits == 16) && (isColoured || isGrey) && layout.width > 0 &&
        layout.height > 0 && layout.width <= most && layout.height <= most;
    return isPlain ? std::optional(layout) : std::nullopt;
}

/// Rounded and not cut off, so that every level stands for as many values.
template<typename Channel> std::uint8_t inEightBits(Channel value) {
    constexpr auto most = std::numeric_limits<Channel>::max();
    return static_cast<std::uint8_t>((255u * value + most / 2) / most);
}

template<typename Channel> void spread(const Channel* row, const TiffLayout& layout, std::uint8_t* pixel) {
    for (std::uint32_t x = 0; x < layout.width; ++x, row += layout.channels, pixel += 4) {
        for (std::size_t i = 0; i < 3; ++i)
            pixel[i] = inEightBits(row[layout.channels == 3 ? i : 0]);
        pixel[3] = 255;
    }
}

/// None where rows are damaged.
template<typename Channel> std::optional<Image> readRows(TIFF* file, const TiffLayout& layout) {
    std::vector<Channel> row(std::size_t{layout.width} * layout.channels);
    if (TIFFScanlineSize64(file) != row.size() * sizeof(Channel)) return std::nullopt;
    Image image{static_cast<int>(layout.width), static_cast<int>(layout.height), {}};
    image.pixels.resize(4 * std::size_t{layout.width} * layout.height);
    for (std::uint32_t y = 0; y < layout.height; ++y) {
        if (TIFFReadScanline(file, row.data(), y) != 1) return std::nullopt;
        spread(row.data(), layout, image.at(0, static_cast<int>(y)));
    }
    return image;
}

} // namespace

bool isTiff(ByteView encoded) {
    return encoded.size() > 4 &&
           (std::memcmp(encoded.data(), "II*\0", 4) == 0 || std::memcmp(encoded.data(), "MM\0*", 4) == 0);
}

std::optional<Image> decodePlainTiff(ByteView encoded) {
    TiffSource source{encoded};
    const TiffFile file = openTiff(source);
    const auto layout = file ? plainLayoutOf(file.get()) : std::nullopt;
    if (!layout) return std::nullopt;
    return layout->bits == 8 ? readRows<std::uint8_t>(file.get(), *layout)
                             : readRows<std::uint16_t>(file.get(), *layout);
}

} // namespace esm
