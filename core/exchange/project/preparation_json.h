#pragma once

#include "core/support/json_reader.h"
#include "core/texture/photo/photo_preparation.h"

#include <filesystem>

namespace esm {

/// A lens; keys that are not known are refused, in a project too. Its numbers are finite, and no more is
/// checked: `validate()` does.
void fromJson(const JsonReader& reader, Lens& lens);
nlohmann::ordered_json toJson(const Lens& lens);

/// A photo's preparation as `docs/project-file.md` describes it. Its numbers are finite, and no more is
/// checked: `validate()` does.
void fromJson(const JsonReader& reader, PhotoPreparation& preparation);
nlohmann::ordered_json toJson(const PhotoPreparation& preparation);

/// A lens in the form that it has in a preparation. @throws FileError
Lens readLensFile(const std::filesystem::path& file);
void writeLensFile(const Lens& lens, const std::filesystem::path& file); ///< @throws FileError

} // namespace esm
