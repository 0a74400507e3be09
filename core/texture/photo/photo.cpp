#include "core/texture/photo/photo.h"

#include "core/decoding/decoder_process.h"
#include "core/support/errors.h"
#include "core/texture/photo/photo_format.h"
#include "core/texture/texture_limits.h"

#include <cstring>

namespace esm {

namespace {

constexpr std::uintmax_t mostBytes = 1'000'000'000;

/// What the decoder's process hands back is as little trusted as the file: the picture must have the size
/// that the header promised, lying or standing, and nothing may follow it.
Image readPicture(DecodedStream& stream, const PhotoFormat& format) {
    const auto width = stream.value<std::uint32_t>(), height = stream.value<std::uint32_t>();
    const bool isStored = width == format.width && height == format.height;
    const bool isTurned = width == format.height && height == format.width;
    if (!isStored && !isTurned) stream.failAsNonsense();
    Image image{static_cast<int>(width), static_cast<int>(height), {}};
    image.pixels = stream.array<std::uint8_t>(4 * std::uint64_t{width} * height);
    if (stream.left() > 0) stream.failAsNonsense();
    return image;
}

/// The picture as it is to be shown. EXIF 2.3, 4.6.4 A says where the stored picture's first row and column
/// lie.
Image upright(Image stored, int orientation) {
    if (orientation == 1) return stored;
    const bool rowsBecomeColumns = orientation >= 5;
    const bool rowsRunBack = orientation == 3 || orientation == 4 || orientation == 6 || orientation == 7;
    const bool columnsRunBack = orientation == 2 || orientation == 3 || orientation == 7 || orientation == 8;
    Image shown{stored.width, stored.height, {}};
    if (rowsBecomeColumns) std::swap(shown.width, shown.height);
    shown.pixels.resize(stored.pixels.size());
    for (int y = 0; y < shown.height; ++y)
        for (int x = 0; x < shown.width; ++x) {
            const int row = rowsBecomeColumns ? x : y, column = rowsBecomeColumns ? y : x;
            std::memcpy(shown.at(x, y),
                        stored.at(columnsRunBack ? stored.width - 1 - column : column,
                                  rowsRunBack ? stored.height - 1 - row : row),
                        4);
        }
    return shown;
}

/// @param shown the file as messages name it
std::shared_ptr<const Photo> makePhoto(const std::filesystem::path& shown, std::string name, Bytes encoded,
                                       const Progress& progress) {
    const PhotoFormat format = inspectPhoto(encoded);
    if (!format.problem.empty()) throw FileError(shown, format.problem);
    if (format.width > texture_limits::mostPhotoPixels / format.height)
        throw FileError(shown, "is larger than 268 megapixels (" + std::to_string(format.width) + " × " +
                                   std::to_string(format.height) + "); scale it down");
    const DecodingLimits limits = pictureDecodingLimits(format.width * format.height, encoded.size());
    DecodedStream stream = decodeApart({shown, {"picture"}, &encoded, limits}, progress);
    auto photo = std::make_shared<Photo>();
    photo->image = upright(readPicture(stream, format), format.orientation);
    photo->fileName = std::move(name);
    photo->encoded = std::move(encoded);
    return photo;
}

} // namespace

std::shared_ptr<const Photo> loadPhoto(const std::filesystem::path& file, const Progress& progress) {
    if (regularFileSize(file) > mostBytes) throw FileError(file, "is larger than 1 GB; choose a photo");
    return makePhoto(file, file.filename().string(), readFile(file), progress);
}

std::shared_ptr<const Photo> decodePhoto(std::string name, Bytes encoded, const Progress& progress) {
    const std::filesystem::path shown = name;
    return makePhoto(shown, std::move(name), std::move(encoded), progress);
}

} // namespace esm
