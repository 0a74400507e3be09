#include "core/exchange/fuzzy/embedded_presets.h"
#include "core/support/json_reader.h"

#include <cstring>

namespace esm {

std::vector<std::string> namesOf(const std::vector<EmbeddedPreset>& presets) {
    std::vector<std::string> names;
    names.reserve(presets.size());
    for (const EmbeddedPreset& preset : presets)
        names.emplace_back(preset.name);
    return names;
}

std::optional<nlohmann::ordered_json> jsonOf(const std::vector<EmbeddedPreset>& presets,
                                             const std::string& name) {
    for (const EmbeddedPreset& preset : presets)
        if (name == preset.name) return parseJson(preset.json, preset.json + std::strlen(preset.json));
    return std::nullopt;
}

} // namespace esm
