#pragma once

#include "core/geometry/length_unit.h"
#include "core/geometry/mesh_source.h"
#include "core/geometry/polygon_soup.h"
#include "core/support/progress.h"
#include "core/support/words.h"

#include <Eigen/Core>

#include <array>
#include <filesystem>
#include <string>
#include <vector>

namespace esm {

/// The direction of a file that points up.
enum class UpAxis { Y, Z, X, MinusY, MinusZ, MinusX };

template<>
inline constexpr auto wordsOf<UpAxis> = std::array{Word{UpAxis::Y, "y"},
                                                   Word{UpAxis::Z, "z"},
                                                   Word{UpAxis::X, "x"},
                                                   Word{UpAxis::MinusY, "minus-y"},
                                                   Word{UpAxis::MinusZ, "minus-z"},
                                                   Word{UpAxis::MinusX, "minus-x"}};

/// Reads a surface, in a process of its own. Node transforms are applied; lines and points are ignored.
/// Coordinates and the order of the faces are the file's.
/// @param progress asked now and then whether to go on; how much is done is not known
/// @throws FileError: missing, empty, truncated, of an unknown format, without a triangle, not finite, or
/// beyond what reading it may take of memory and time; Cancelled
PolygonSoup readMeshFile(const std::filesystem::path& file, const Progress& progress = {});

/// Names the file, with the sum of its bytes; of what lies beside it, as buffers of a .gltf, there is none.
/// @throws FileError: missing or unreadable; Cancelled
MeshSource meshSourceOf(const std::filesystem::path& file, const Progress& progress = {});

/// Turns so that the direction becomes y, by whole quarters about one axis: all entries are 0, 1 or −1.
Eigen::Matrix3d turnedUp(UpAxis up);

/// Converts to metres and to Y up.
void convertToMetres(std::vector<Eigen::Vector3d>& points, LengthUnit unit, UpAxis up);
void convertToMetres(PolygonSoup& soup, LengthUnit unit, UpAxis up);

/// File name endings that readMeshFile() takes, without the dot.
const std::vector<std::string>& meshFileEndings();

/// The name's ending in small letters, without the dot; empty where it has none.
std::string meshFileEnding(const std::filesystem::path& file);

} // namespace esm
