#pragma once

#include "core/support/file_io.h"

#include <cstdint>
#include <string>
#include <vector>

namespace esm {

/// What a picture file says of itself before anything is decoded.
struct PhotoFormat {
    std::string problem;                 ///< why it cannot be used and what to do; empty when it can
    std::uint64_t width = 0, height = 0; ///< pixels
    int orientation = 1;                 ///< 1 to 8, as EXIF counts them; TIFF decoders see to it themselves
};

/// Walks through the structure of a PNG or JPEG file to its end, since decoders fill up a truncated picture
/// with grey in silence and allocate whatever size a header claims. Of a BMP file the header is compared with
/// the file's size, of a TIFF file the first directory read.
PhotoFormat inspectPhoto(const Bytes& encoded);

/// File name endings of the formats that are read, in small letters and without the dot.
const std::vector<std::string>& photoFileEndings();

} // namespace esm
