#include "core/exchange/project/tissue_preset_file.h"

#include "core/exchange/fuzzy/embedded_presets.h"
#include "core/exchange/fuzzy/fuzzy_file.h"
#include "core/exchange/project/scene_file.h"
#include "core/support/errors.h"
#include "core/support/joined.h"
#include "core/support/json_reader.h"

namespace esm {

using Json = nlohmann::ordered_json;

namespace {

std::optional<double> optionalNumber(const JsonReader& reader, const char* key) {
    return reader.has(key) ? std::optional(reader.member(key).number()) : std::nullopt;
}

TissueValues publishedFromJson(const JsonReader& reader) {
    TissueValues values;
    values.mass = optionalNumber(reader, "mass");
    if (!reader.has("published")) return values;
    const JsonReader published = reader.member("published");
    values.springConstant = optionalNumber(published, "spring_constant");
    values.viscosity = optionalNumber(published, "viscosity");
    return values;
}

void readWords(TissuePreset& preset, const JsonReader& reader) {
    if (!reader.has("system")) return;
    preset.system = std::make_shared<const FuzzySystem>(fuzzyPreset(reader.member("system").text()));
    for (const auto& [input, value] : reader.member("inputs").members())
        preset.inputs.emplace_back(input, value.number());
}

} // namespace

TissuePreset tissuePresetFromJson(const Json& json) {
    std::vector<std::string> problems;
    const JsonReader reader(json, "", problems);
    reader.allowOnly(
        {"name", "title", "description", "source", "system", "inputs", "published", "mass", "tethers"});
    TissuePreset preset;
    preset.name = reader.member("name").text();
    preset.title = reader.member("title").text();
    preset.description = reader.member("description").text();
    preset.source = reader.member("source").text();
    preset.published = publishedFromJson(reader);
    readWords(preset, reader);
    if (reader.has("tethers"))
        preset.tethers =
            sceneFromJson({{"duration", 1}, {"tethers", reader.member("tethers").json()}}).tethers;
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
