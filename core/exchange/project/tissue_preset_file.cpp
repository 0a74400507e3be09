#include "core/exchange/project/tissue_preset_file.h"

#include "core/exchange/fields_json.h"
#include "core/exchange/fuzzy/embedded_presets.h"
#include "core/exchange/fuzzy/fuzzy_file.h"
#include "core/support/errors.h"
#include "core/support/joined.h"

namespace esm {

using Json = nlohmann::ordered_json;

namespace {

/// A system stands by its name, inputs as an object by theirs.
struct PresetForms : TypedForms {
    void read(const JsonReader& reader, std::shared_ptr<const FuzzySystem>& system) const {
        system = std::make_shared<const FuzzySystem>(fuzzyPreset(reader.text()));
    }
    void read(const JsonReader& reader, NamedValues& inputs) const {
        for (const auto& [input, value] : reader.members())
            inputs.emplace_back(input, value.number());
    }
};

} // namespace

TissuePreset tissuePresetFromJson(const Json& json) {
    std::vector<std::string> problems;
    TissuePreset preset = valueFrom<TissuePreset>(JsonReader(json, "", problems), PresetForms());
    if (!problems.empty()) throw InvalidModel(problems);
    return preset;
}

std::vector<std::string> tissuePresetNames() {
    return namesOf(embeddedTissuePresets());
}

TissuePreset tissuePreset(const std::string& name) {
    if (const auto json = jsonOf(embeddedTissuePresets(), name)) return tissuePresetFromJson(*json);
    throw InvalidModel("there is no tissue \"" + name + "\"; there are " + joined(tissuePresetNames()));
}

} // namespace esm
