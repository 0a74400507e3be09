#pragma once

#include "core/decoding/decoded_stream.h"
#include "core/geometry/polygon_soup.h"

namespace esm {

/// A surface on its way between processes: four counts, coordinates, how many corners each polygon has,
/// corners, and where there are any, of how many corners of each polygon the place in a texture is known, all
/// or none, and these places.
void writeSoup(const PolygonSoup& soup, DecodedWriter& writer);

/// @throws FileError where it is not whole, has no polygon, a coordinate or place is not finite or a corner
/// names no vertex
PolygonSoup readSoup(DecodedStream& stream);

} // namespace esm
