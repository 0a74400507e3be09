#include "core/texture/photo/photo_format.h"

#include "core/support/byte_order.h"

#include <cstdlib>
#include <cstring>
#include <optional>
#include <zlib.h>

namespace esm {

namespace {

const char* const truncated = "ends before the picture does; copy or export it again";
const char* const damaged = "is damaged; copy or export it again";
const char* const animated = "is animated; save one of its pictures as PNG or JPEG";

/// Numbers at places in a file that may be shorter than it says.
class Cursor {
public:
    Cursor(const Bytes& bytes, ByteOrder order) : m_bytes(bytes), m_order(order) {}

    bool holds(std::size_t place, std::size_t size) const {
        return place <= m_bytes.size() && size <= m_bytes.size() - place;
    }
    /// 0 where the file ends before it does.
    std::uint32_t number(std::size_t place, std::size_t size) const {
        if (!holds(place, size)) return 0;
        return static_cast<std::uint32_t>(unsignedNumber(m_bytes.data() + place, size, m_order));
    }
    bool startsWith(const char* text, std::size_t place = 0) const {
        const std::size_t length = std::strlen(text);
        return holds(place, length) && std::memcmp(m_bytes.data() + place, text, length) == 0;
    }
    std::size_t size() const { return m_bytes.size(); }
    /// Empty where the file ends before it does.
    Bytes part(std::size_t place, std::size_t size) const {
        if (!holds(place, size)) return {};
        const auto begin = m_bytes.begin() + static_cast<std::ptrdiff_t>(place);
        return {begin, begin + static_cast<std::ptrdiff_t>(size)};
    }

private:
    const Bytes& m_bytes;
    ByteOrder m_order;
};

/// CRC-32, as PNG has behind each chunk.
std::uint32_t checksum(const Bytes& bytes, std::size_t place, std::size_t size) {
    return static_cast<std::uint32_t>(crc32_z(0, bytes.data() + place, size));
}

/// The orientation tag of EXIF data, which is a TIFF file without a picture; 1 where it has none.
int exifOrientation(const Bytes& exif) {
    const bool isLittle = exif.size() > 1 && exif[0] == 'I';
    const Cursor cursor(exif, isLittle ? ByteOrder::Little : ByteOrder::Big);
    const std::size_t directory = cursor.number(4, 4);
    const std::size_t entries = cursor.number(directory, 2);
    for (std::size_t i = 0; i < entries && cursor.holds(directory + 2 + 12 * i, 12); ++i) {
        const std::size_t entry = directory + 2 + 12 * i;
        const std::uint32_t value = cursor.number(entry + 8, 2);
        if (cursor.number(entry, 2) == 274 && value >= 1 && value <= 8) return static_cast<int>(value);
    }
    return 1;
}

/// Eight bytes of signature, then chunks: length, name, data, checksum. The first holds the size, at a fixed
/// place; IEND is the last. A chunk acTL is that of an animation (APNG). The checksums find what was damaged
/// before it is decoded.
PhotoFormat inspectPng(const Bytes& encoded) {
    const Cursor cursor(encoded, ByteOrder::Big);
    PhotoFormat format;
    format.width = cursor.number(16, 4);
    format.height = cursor.number(20, 4);
    constexpr std::size_t frame = 12; // length, name and checksum of a chunk
    for (std::size_t place = 8; cursor.holds(place, frame);) {
        if (cursor.startsWith("IEND", place + 4)) return format;
        const std::size_t length = cursor.number(place, 4);
        if (!cursor.holds(place, frame + length)) break;
        if (checksum(encoded, place + 4, 4 + length) != cursor.number(place + 8 + length, 4)) {
            format.problem = damaged;
            return format;
        }
        if (cursor.startsWith("acTL", place + 4)) {
            format.problem = animated;
            return format;
        }
        if (cursor.startsWith("eXIf", place + 4))
            format.orientation = exifOrientation(cursor.part(place + 8, length));
        place += frame + length;
    }
    format.problem = truncated;
    return format;
}

/// The next marker at or after `place`, its 0xff included; stuffed zeros and restarts belong to the picture's
/// data.
std::size_t nextJpegMarker(const Cursor& cursor, std::size_t place) {
    for (; cursor.holds(place, 2); ++place) {
        if (cursor.number(place, 1) != 0xff) continue;
        const std::uint32_t code = cursor.number(place + 1, 1);
        if (code != 0 && code != 0xff && (code < 0xd0 || code > 0xd7)) return place;
    }
    return cursor.size();
}

/// Of EXIF data in a segment of a JPEG file; 1 where it holds other things.
int segmentOrientation(const Cursor& cursor, std::size_t place) {
    constexpr std::size_t exifBegin = 10; // behind marker, length and name
    const std::size_t length = cursor.number(place + 2, 2);
    if (length < exifBegin - 2 || !cursor.startsWith("Exif", place + 4)) return 1;
    return exifOrientation(cursor.part(place + exifBegin, length + 2 - exifBegin));
}

/// Of the sixteen markers from 0xc0 on all but three, which hold tables and extensions, begin a frame and
/// tell its size.
bool isFrameMarker(std::uint32_t code) {
    return code >= 0xc0 && code <= 0xcf && code != 0xc4 && code != 0xc8 && code != 0xcc;
}

/// Segments, each a marker and its length, from the start of the image to its end. A progressive picture has
/// the compressed data of several scans between them, in which the next marker is looked for. Without the end
/// marker decoders would fill what is missing with grey and say nothing.
PhotoFormat inspectJpeg(const Bytes& encoded) {
    constexpr std::uint32_t endOfImage = 0xd9, startOfImage = 0xd8, application = 0xe1;
    const Cursor cursor(encoded, ByteOrder::Big);
    PhotoFormat format;
    std::size_t place = nextJpegMarker(cursor, 2);
    while (cursor.holds(place, 4)) {
        const std::uint32_t code = cursor.number(place + 1, 1);
        if (code == endOfImage || code == startOfImage) break;
        if (isFrameMarker(code)) {
            format.height = cursor.number(place + 5, 2);
            format.width = cursor.number(place + 7, 2);
        }
        if (code == application && format.orientation == 1)
            format.orientation = segmentOrientation(cursor, place);
        place = nextJpegMarker(cursor, place + 2 + cursor.number(place + 2, 2));
    }
    if (cursor.number(place + 1, 1) != endOfImage) format.problem = truncated;
    return format;
}

/// The header of 12 bytes is that of OS/2, with numbers half as wide. A height below zero says that rows come
/// from the top.
PhotoFormat inspectBmp(const Bytes& encoded) {
    const Cursor cursor(encoded, ByteOrder::Little);
    PhotoFormat format;
    const bool old = cursor.number(14, 4) == 12;
    const auto height = static_cast<std::int32_t>(cursor.number(old ? 20 : 22, old ? 2 : 4));
    format.width = cursor.number(18, old ? 2 : 4);
    format.height = static_cast<std::uint64_t>(std::abs(static_cast<std::int64_t>(height)));
    if (!cursor.holds(0, cursor.number(2, 4))) format.problem = truncated;
    return format;
}

/// The first directory is the first picture. A number of type 3 has two bytes, any other one here four.
PhotoFormat inspectTiff(const Bytes& encoded, ByteOrder order) {
    const Cursor cursor(encoded, order);
    PhotoFormat format;
    const std::size_t directory = cursor.number(4, 4);
    const std::size_t entries = cursor.number(directory, 2);
    if (!cursor.holds(directory, 2 + 12 * entries)) {
        format.problem = truncated;
        return format;
    }
    for (std::size_t i = 0; i < entries; ++i) {
        const std::size_t entry = directory + 2 + 12 * i;
        const std::uint32_t tag = cursor.number(entry, 2);
        const std::uint32_t value = cursor.number(entry + 8, cursor.number(entry + 2, 2) == 3 ? 2 : 4);
        if (tag == 256) format.width = value;
        if (tag == 257) format.height = value;
    }
    return format;
}

std::optional<PhotoFormat> inspectStructure(const Bytes& encoded) {
    const Cursor cursor(encoded, ByteOrder::Big);
    if (cursor.startsWith("\x89PNG\r\n\x1a\n")) return inspectPng(encoded);
    if (cursor.startsWith("\xff\xd8\xff")) return inspectJpeg(encoded);
    if (cursor.startsWith("BM")) return inspectBmp(encoded);
    if (cursor.startsWith("II*")) return inspectTiff(encoded, ByteOrder::Little);
    if (cursor.number(0, 4) == 0x4d4d002a) return inspectTiff(encoded, ByteOrder::Big);
    return std::nullopt;
}

} // namespace

PhotoFormat inspectPhoto(const Bytes& encoded) {
    PhotoFormat format;
    if (encoded.empty()) {
        format.problem = "is empty; choose a PNG, JPEG, BMP or TIFF picture";
        return format;
    }
    const std::optional<PhotoFormat> found = inspectStructure(encoded);
    if (!found) {
        format.problem = "is not a PNG, JPEG, BMP or TIFF picture; convert it to PNG or JPEG";
        return format;
    }
    format = *found;
    if (format.problem.empty() && (format.width == 0 || format.height == 0)) format.problem = damaged;
    return format;
}

const std::vector<std::string>& photoFileEndings() {
    static const std::vector<std::string> endings{"png", "jpg", "jpeg", "bmp", "tif", "tiff"};
    return endings;
}

} // namespace esm
