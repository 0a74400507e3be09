#pragma once

#include "core/texture/image.h"

#include <cstdint>
#include <optional>
#include <span>

namespace esm {

using ByteView = std::span<const std::uint8_t>;

/// A picture as it is stored, before it is turned upright: 16 bits a channel are rounded to 8, grey becomes
/// red, green and blue, printer's inks are mixed, and what has no alpha is opaque.
/// @throws std::runtime_error when it is damaged; std::bad_alloc
Image decodePng(ByteView encoded);
Image decodeJpeg(ByteView encoded);

/// Of BMP files only those with 24 bits a pixel and no compression, as cameras and frame grabbers write them;
/// none of the others. @throws std::runtime_error when it is cut off
std::optional<Image> decodePlainBmp(ByteView encoded);

/// Of TIFF files those with rows of 8 or 16 bits of grey or of red, green and blue, as cameras and scanners
/// write them, however packed; none of the others, and none that is damaged.
std::optional<Image> decodePlainTiff(ByteView encoded);

/// What begins every file of the format.
bool isPng(ByteView encoded);
bool isJpeg(ByteView encoded);
bool isBmp(ByteView encoded);
bool isTiff(ByteView encoded);

} // namespace esm
