#pragma once

#include "core/support/file_io.h"
#include "core/texture/image.h"

#include <optional>

namespace esm {

/// A picture as it is stored, before it is turned upright: 16 bits a channel are rounded to 8, grey becomes
/// red, green and blue, printer's inks are mixed, and what has no alpha is opaque.
/// @throws std::runtime_error when it is damaged; std::bad_alloc
Image decodePng(const Bytes& encoded);
Image decodeJpeg(const Bytes& encoded);

/// Of BMP files only those with 24 bits a pixel and no compression, as cameras and frame grabbers write them;
/// none of the others. @throws std::runtime_error when it is cut off
std::optional<Image> decodePlainBmp(const Bytes& encoded);

/// Of TIFF files those with rows of 8 or 16 bits of grey or of red, green and blue, as cameras and scanners
/// write them, however packed; none of the others, and none that is damaged.
std::optional<Image> decodePlainTiff(const Bytes& encoded);

/// What begins every file of the format.
bool isPng(const Bytes& encoded);
bool isJpeg(const Bytes& encoded);
bool isBmp(const Bytes& encoded);
bool isTiff(const Bytes& encoded);

} // namespace esm
