#pragma once

#include "core/model/scene.h"
#include "core/support/json_reader.h"

#include <filesystem>

namespace esm {

/// Scene JSON as in `docs/command-line.md`. Unknown keys are refused, so that a misspelt load is not lost.
Scene sceneFromJson(const nlohmann::ordered_json& json); ///< @throws InvalidModel with every problem
/// The same of a part of a file; its problems are noted there.
Scene readScene(const JsonReader& reader);
nlohmann::ordered_json toJson(const Scene& scene);
Scene readSceneFile(const std::filesystem::path& file); ///< @throws FileError

} // namespace esm
