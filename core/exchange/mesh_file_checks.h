#pragma once

#include "core/support/file_io.h"

#include <filesystem>
#include <string>

namespace esm {

/// Checks, before a reader or importer sees it, that a mesh file's content is what its name ending says and,
/// for those that assimp reads, complete: announced counts fit the file's size, parts named in it are there.
/// Importers take what is missing for zero, or believe a lying header. `ending` is in lower case, without the
/// dot.
/// @throws FileError saying what is wrong, where, and what to do
void checkMeshContent(const std::filesystem::path& file, const Bytes& content, const std::string& ending);

/// The checks of single formats.
void checkOff(const std::filesystem::path& file, const Bytes& content);
void checkStl(const std::filesystem::path& file, const Bytes& content);
void checkPly(const std::filesystem::path& file, const Bytes& content);
void checkGltf(const std::filesystem::path& file, const Bytes& content);
void checkGlb(const std::filesystem::path& file, const Bytes& content);

} // namespace esm
