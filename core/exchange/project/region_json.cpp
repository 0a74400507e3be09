#include "core/exchange/project/region_json.h"

#include "core/exchange/fuzzy/fuzzy_file.h"
#include "core/exchange/project/ellipsoid_json.h"
#include "core/support/errors.h"

#include <algorithm>

namespace esm {

using Json = nlohmann::ordered_json;

namespace {

Json toJson(const TissueValues& values) {
    Json json = Json::object();
    if (values.springConstant) json["springConstant"] = *values.springConstant;
    if (values.viscosity) json["viscosity"] = *values.viscosity;
    if (values.mass) json["mass"] = *values.mass;
    return json;
}

TissueValues tissueValuesFromJson(const JsonReader& reader) {
    const auto value = [&](const char* key) {
        return reader.has(key) ? std::optional<double>(reader.member(key).number()) : std::nullopt;
    };
    return {value("springConstant"), value("viscosity"), value("mass")};
}

Json inputsToJson(const NamedValues& inputs) {
    Json json = Json::array();
    for (const auto& [variable, value] : inputs)
        json.push_back({{"variable", variable}, {"value", value}});
    return json;
}

/// A preset's description is left out: programs that know the preset know it, and older ones refuse the key.
/// One that was emptied is therefore written as such.
Json systemToJson(const FuzzySystem& system) {
    Json json = esm::toJson(system);
    if (!isFuzzyPreset(system)) return json;
    if (system.description == fuzzyPreset(system.name).description)
        json.erase("description");
    else
        json["description"] = system.description;
    return json;
}

/// The place of a system in the list, added where it is not there yet. Compared by content, so that equal
/// projects give equal files whether or not their regions share a system.
std::size_t placeOf(const FuzzySystem& system, Json& systems) {
    Json json = systemToJson(system);
    const auto found = std::find(systems.begin(), systems.end(), json);
    const auto place = static_cast<std::size_t>(found - systems.begin());
    if (found == systems.end()) systems.push_back(std::move(json));
    return place;
}

Region regionFromJson(const JsonReader& reader,
                      const std::vector<std::shared_ptr<const FuzzySystem>>& systems) {
    Region region;
    region.name = reader.member("name").text();
    region.colour = colourFromJson(reader.member("colour"));
    if (reader.has("ellipsoid")) region.ellipsoid = ellipsoidFromJson(reader.member("ellipsoid"));
    if (reader.has("rim")) region.rim = reader.member("rim").number();
    if (reader.has("fuzzySystem")) {
        if (systems.empty())
            reader.addProblem("names a fuzzy system, but the file holds none");
        else
            region.system = systems[reader.member("fuzzySystem").integer(0, systems.size() - 1)];
    }
    for (const JsonReader& input : reader.member("inputs").elements())
        region.inputs.emplace_back(input.member("variable").text(), input.member("value").number());
    region.held = tissueValuesFromJson(reader.member("held"));
    return region;
}

std::shared_ptr<const FuzzySystem> systemFromJson(const JsonReader& reader) {
    try {
        FuzzySystem system = fuzzySystemFromJson(reader.json());
        if (!reader.has("description") && isFuzzyPreset(system))
            system.description = fuzzyPreset(system.name).description;
        return std::make_shared<const FuzzySystem>(std::move(system));
    } catch (const InvalidModel& error) {
        for (const std::string& problem : error.problems())
            reader.addProblem("is no usable fuzzy system: " + problem);
        return nullptr;
    }
}

} // namespace

RegionsJson toJson(const std::vector<Region>& regions) {
    RegionsJson result;
    for (const Region& region : regions) {
        Json json{{"name", region.name}, {"colour", colourToJson(region.colour)}};
        if (region.ellipsoid) json["ellipsoid"] = toJson(*region.ellipsoid);
        if (region.rim != 0) json["rim"] = region.rim;
        if (region.system) json["fuzzySystem"] = placeOf(*region.system, result.systems);
        json["inputs"] = inputsToJson(region.inputs);
        json["held"] = toJson(region.held);
        result.regions.push_back(std::move(json));
    }
    return result;
}

std::vector<Region> regionsFromJson(const JsonReader& systems, const JsonReader& regions) {
    std::vector<std::shared_ptr<const FuzzySystem>> shared;
    for (const JsonReader& system : systems.elements())
        shared.push_back(systemFromJson(system));
    std::vector<Region> result;
    for (const JsonReader& region : regions.elements())
        result.push_back(regionFromJson(region, shared));
    return result;
}

Json colourToJson(const std::array<std::uint8_t, 3>& colour) {
    return Json::array({colour[0], colour[1], colour[2]});
}

std::array<std::uint8_t, 3> colourFromJson(const JsonReader& reader) {
    std::array<std::uint8_t, 3> colour{};
    const std::vector<JsonReader> channels = reader.elements();
    if (channels.size() != colour.size() && !reader.json().is_null())
        reader.addProblem("should be three numbers: red, green, blue");
    for (std::size_t i = 0; i < std::min(channels.size(), colour.size()); ++i)
        colour[i] = static_cast<std::uint8_t>(channels[i].integer(0, 255));
    return colour;
}

} // namespace esm
