#pragma once

#include "core/exchange/jpeg_file.h"
#include "core/support/words.h"

#include <array>
#include <string>

namespace esm {

enum class PictureFormat {
    Png,  ///< every texel as it is
    Jpeg, ///< a fraction of the size, texels nearly as they are
};
template<>
inline constexpr auto wordsOf<PictureFormat> =
    std::array{Word{PictureFormat::Png, "png"}, Word{PictureFormat::Jpeg, "jpeg"}};

/// How the pages of a texture are stored.
struct PictureEncoding {
    PictureFormat format = PictureFormat::Png;
    int quality = usualJpegQuality; ///< of JPEG alone, 1 to 100

    bool operator==(const PictureEncoding&) const = default;
};

std::string endingOf(PictureFormat format);    ///< ".png"
std::string mediaTypeOf(PictureFormat format); ///< "image/png"

/// @param texelsPerMetre 0: none is noted
/// @throws InvalidModel as encodePng() and encodeJpeg(); Cancelled
Bytes encodePicture(const Image& image, const PictureEncoding& encoding, double texelsPerMetre = 0,
                    const Progress& progress = {});

} // namespace esm
