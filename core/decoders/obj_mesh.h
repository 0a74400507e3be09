#pragma once

#include "core/geometry/polygon_soup.h"
#include "core/support/file_io.h"

#include <filesystem>

namespace esm {

/// Reads vertices and faces of Wavefront OBJ text; everything else in it is skipped. A reader of our own
/// because node numbers follow the order of the file's faces, which assimp regroups by object and material,
/// and because it repeats a vertex for every corner, so that welds and unused vertices could not be counted.
/// `file` stands in messages. @throws FileError naming the line when the content is damaged or no OBJ
PolygonSoup parseObj(const std::filesystem::path& file, const Bytes& content);

} // namespace esm
