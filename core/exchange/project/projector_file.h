#pragma once

#include "core/support/json_reader.h"
#include "core/texture/projection/projector.h"

#include <filesystem>

namespace esm {

/// Projector JSON as in `docs/command-line.md`. A pose that is a rotation but for few digits is turned to the
/// nearest one.
Projector projectorFromJson(const JsonReader& reader);
inline void fromJson(const JsonReader& reader, Projector& projector) {
    projector = projectorFromJson(reader);
}
Projector projectorFromJson(const nlohmann::ordered_json& json); ///< @throws InvalidModel with every problem
nlohmann::ordered_json toJson(const Projector& projector);
Projector readProjectorFile(const std::filesystem::path& file); ///< @throws FileError

} // namespace esm
