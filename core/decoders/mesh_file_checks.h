#pragma once

#include "core/support/file_io.h"

#include <Eigen/Core>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace esm {

/// Checks, before a reader or importer sees it, that a mesh file's content is what its name ending says and,
/// for those that assimp reads, complete: announced counts fit the file's size, parts named in it are there.
/// Importers take what is missing for zero, or believe a lying header. `ending` is in lower case, without the
/// dot.
/// @return how many faces the importer has to deliver, where the file says so
/// @throws FileError saying what is wrong, where, and what to do
std::optional<std::size_t> checkMeshContent(const std::filesystem::path& file, const Bytes& content,
                                            const std::string& ending);

/// The checks of single formats. They return the number of faces announced; a PLY file with strips
/// of triangles announces none.
std::size_t checkOff(const std::filesystem::path& file, const Bytes& content);
std::size_t checkStl(const std::filesystem::path& file, const Bytes& content);
std::optional<std::size_t> checkPly(const std::filesystem::path& file, const Bytes& content);
std::size_t checkGltf(const std::filesystem::path& file, const Bytes& content);
std::size_t checkGlb(const std::filesystem::path& file, const Bytes& content);

/// Texture coordinates of every face's corners.
using FaceCoordinates = std::vector<std::vector<Eigen::Vector2d>>;

/// What a PLY file says of the corners of its faces, where a vertex at a seam has several coordinates; the
/// importer would keep the last one. Empty where it says nothing.
FaceCoordinates plyFaceCoordinates(const std::filesystem::path& file, const Bytes& content);

} // namespace esm
