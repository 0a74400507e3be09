#pragma once

#include "core/texture/projection/pose_fit.h"

#include <filesystem>

namespace esm {

/// Landmarks as CSV `photo_x,photo_y,x,y,z` under a line of these names; photo pixels and metres. Empty lines
/// say nothing. @throws FileError naming the line
std::vector<LandmarkPair> readPairsFile(const std::filesystem::path& file);

/// The same, with decimals that read back as the same numbers; written atomically.
/// @throws FileError where it cannot be written
void writePairsFile(const std::vector<LandmarkPair>& pairs, const std::filesystem::path& file);

} // namespace esm
