#pragma once

#include "core/geometry/polygon_soup.h"
#include "core/support/file_io.h"

#include <filesystem>

namespace esm {

/// Reads the content of a legacy VTK file, versions 1.0 to 5.1, ASCII or binary, of DATASET POLYDATA: points,
/// polygons and triangle strips. Vertices, lines and attributes are skipped. `file` stands in messages.
/// @throws FileError naming the line (ASCII) or byte (binary) when the content is damaged or of another kind
PolygonSoup parseVtkPolydata(const std::filesystem::path& file, const Bytes& content);

} // namespace esm
