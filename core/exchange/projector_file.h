#pragma once

#include "core/texture/projector.h"

#include <nlohmann/json_fwd.hpp>

#include <filesystem>

namespace esm {

/// Projector JSON as in `docs/command-line.md`.
Projector projectorFromJson(const nlohmann::ordered_json& json); ///< @throws InvalidModel with every problem
nlohmann::ordered_json toJson(const Projector& projector);
Projector readProjectorFile(const std::filesystem::path& file); ///< @throws FileError

} // namespace esm
