#pragma once

#include "core/support/file_io.h"
#include "core/texture/image.h"

#include <filesystem>

namespace esm {

/// PNG by libpng, 8 or 16 bits a channel, with the physical texel size where one is given (texels per metre,
/// 0 for none) and sRGB noted. @throws InvalidModel for a picture without pixels or larger than memory;
/// Cancelled
Bytes encodePng(const Image& image, double texelsPerMetre = 0, const Progress& progress = {});
Bytes encodePng(const DeepImage& image, double texelsPerMetre = 0);
void writePng(const Image& image, const std::filesystem::path& file,
              double texelsPerMetre = 0); ///< @throws FileError, InvalidModel as encodePng()

} // namespace esm
