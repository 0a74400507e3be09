#include "core/exchange/picture_encoding.h"

#include "core/exchange/image_file.h"

namespace esm {

std::string endingOf(PictureFormat format) {
    return format == PictureFormat::Jpeg ? ".jpg" : ".png";
}

std::string mediaTypeOf(PictureFormat format) {
    return format == PictureFormat::Jpeg ? "image/jpeg" : "image/png";
}

Bytes encodePicture(const Image& image, const PictureEncoding& encoding, double texelsPerMetre,
                    const Progress& progress) {
    return encoding.format == PictureFormat::Jpeg
               ? encodeJpeg(image, encoding.quality, texelsPerMetre, progress)
               : encodePng(image, texelsPerMetre, progress);
}

} // namespace esm
