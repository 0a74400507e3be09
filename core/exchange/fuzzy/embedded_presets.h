#pragma once

#include <nlohmann/json_fwd.hpp>

#include <optional>
#include <string>
#include <vector>

namespace esm {

/// A file of `presets/`, compiled in.
struct EmbeddedPreset {
    const char* name; ///< the file's name without `.json`
    const char* json;
};

std::vector<EmbeddedPreset> embeddedFuzzyPresets();
std::vector<EmbeddedPreset> embeddedTissuePresets(); ///< of `presets/tissue/`

std::vector<std::string> namesOf(const std::vector<EmbeddedPreset>& presets);

/// None where there is no preset of the name.
std::optional<nlohmann::ordered_json> jsonOf(const std::vector<EmbeddedPreset>& presets,
                                             const std::string& name);

} // namespace esm
