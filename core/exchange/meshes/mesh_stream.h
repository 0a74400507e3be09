#pragma once

#include "core/decoding/decoded_stream.h"
#include "core/geometry/polygon_soup.h"

namespace esm {

/// A surface on its way between processes: three counts, coordinates, how many corners each polygon has,
/// corners.
void writeSoup(const PolygonSoup& soup, DecodedWriter& writer);

/// @throws FileError where it is not whole, has no polygon, a coordinate is not finite or a corner names no
/// vertex
PolygonSoup readSoup(DecodedStream& stream);

} // namespace esm
