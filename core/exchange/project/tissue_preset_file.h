#pragma once

#include "core/project/tissue_preset.h"

#include <nlohmann/json_fwd.hpp>

namespace esm {

/// A preset in the form of `presets/tissue/*.json`. @throws InvalidModel
TissuePreset tissuePresetFromJson(const nlohmann::ordered_json& json);

/// The tissues that ship with the program, compiled in from `presets/tissue/`.
std::vector<std::string> tissuePresetNames();
TissuePreset tissuePreset(const std::string& name); ///< @throws InvalidModel naming the presets there are

} // namespace esm
