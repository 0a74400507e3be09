#pragma once

#include "core/geometry/polygon_soup.h"

#include <filesystem>
#include <string>
#include <vector>

namespace esm {

enum class LengthUnit { Millimetre, Centimetre, Metre };
enum class UpAxis { Y, Z };

double metresPer(LengthUnit unit);

/// Reads a surface: OBJ, STL, PLY, OFF, glTF and GLB through assimp, legacy VTK polydata by our own reader. Node
/// transforms are applied; lines and points are ignored. Coordinates are the file's.
/// @throws FileError: missing, empty, truncated, of an unknown format, without a triangle, not finite
PolygonSoup readMeshFile(const std::filesystem::path& file);

/// Converts to metres and to Y up.
void convertToMetres(PolygonSoup& soup, LengthUnit unit, UpAxis up);

/// File name endings that readMeshFile() takes, without the dot.
const std::vector<std::string>& meshFileEndings();

} // namespace esm
