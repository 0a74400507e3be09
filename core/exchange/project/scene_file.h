#pragma once

#include "core/model/scene.h"

#include <nlohmann/json_fwd.hpp>

#include <filesystem>

namespace esm {

/// Scene JSON as in `docs/command-line.md`. Unknown keys are refused, so that a misspelt load is not lost.
Scene sceneFromJson(const nlohmann::ordered_json& json); ///< @throws InvalidModel with every problem
nlohmann::ordered_json toJson(const Scene& scene);
Scene readSceneFile(const std::filesystem::path& file); ///< @throws FileError

} // namespace esm
