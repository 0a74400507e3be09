#pragma once

#include "core/geometry/polygon_soup.h"

#include <filesystem>

namespace esm {

/// Reads a surface as readMeshFile() gives it, in the calling process: STL, PLY, OFF, glTF and GLB through
/// assimp, OBJ and legacy VTK polydata by readers of our own.
/// @throws FileError; std::bad_alloc
PolygonSoup decodeMesh(const std::filesystem::path& file);

} // namespace esm
