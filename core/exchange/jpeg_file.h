#pragma once

#include "core/support/file_io.h"
#include "core/support/progress.h"
#include "core/texture/image.h"

namespace esm {

/// Of JPEG's quality, 1 to 100: from here on what its compression adds to the seams of an organ is less than
/// what interpolation leaves there anyway (`docs/model-package.md` has the figures).
constexpr int usualJpegQuality = 92;
constexpr int leastJpegQuality = 1, mostJpegQuality = 100;

/// JPEG by libjpeg, 8 bits a channel, colours as fine as brightness, with the physical texel size where one
/// is given (texels per metre, 0 for none). @param quality from 1 to 100
/// @throws InvalidModel for a picture without pixels, with transparent ones, larger than JPEG or memory hold,
/// or another quality; Cancelled
Bytes encodeJpeg(const Image& image, int quality = usualJpegQuality, double texelsPerMetre = 0,
                 const Progress& progress = {});

} // namespace esm
