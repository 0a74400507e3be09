#include "core/exchange/project/region_json.h"

#include "core/exchange/fuzzy/fuzzy_file.h"
#include "core/exchange/project/ellipsoid_json.h"
#include "core/support/errors.h"

#include <algorithm>

namespace esm {

using Json = nlohmann::ordered_json;

namespace {

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

Json inputsToJson(const NamedValues& inputs) {
    Json json = Json::array();
    for (const auto& [variable, value] : inputs)
        json.push_back({{"variable", variable}, {"value", value}});
    return json;
}

struct RegionWriting {
    Json& systems;

    Json write(const ByValue<FuzzySystem>& system) const { return placeOf(*system, systems); }
    Json write(const NamedValues& inputs) const { return inputsToJson(inputs); }
};

struct RegionReading {
    const Systems& systems;

    void read(const JsonReader& reader, ByValue<FuzzySystem>& system) const {
        if (systems.empty())
            reader.addProblem("names a fuzzy system, but the file holds none");
        else
            system = systems[reader.integer(0, systems.size() - 1)];
    }
    void read(const JsonReader& reader, NamedValues& inputs) const {
        for (const JsonReader& input : reader.elements())
            inputs.emplace_back(input.member("variable").text(), input.member("value").number());
    }
};

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

/// A file of others may hold the same system twice.
Systems spareOf(const Systems& systems, const std::vector<Region>& regions) {
    Systems spare;
    for (const auto& system : systems) {
        const auto isIt = [&](const Region& region) { return region.system == system; };
        const bool isKnown = !system || isFuzzyPreset(*system) ||
                             std::any_of(regions.begin(), regions.end(), isIt) ||
                             std::find(spare.begin(), spare.end(), system) != spare.end();
        if (!isKnown) spare.push_back(system);
    }
    return spare;
}

} // namespace

RegionsJson toJson(const std::vector<Region>& regions, const Systems& spare) {
    RegionsJson result;
    for (const Region& region : regions)
        result.regions.push_back(writtenFields(region, RegionWriting{result.systems}));
    for (const auto& system : spare)
        if (!isFuzzyPreset(*system)) placeOf(*system, result.systems);
    return result;
}

ReadRegions regionsFromJson(const JsonReader& systems, const JsonReader& regions) {
    Systems shared;
    for (const JsonReader& system : systems.elements())
        shared.emplace_back(systemFromJson(system));
    ReadRegions read{valueFrom<std::vector<Region>>(regions, RegionReading{shared}), {}};
    read.spare = spareOf(shared, read.regions);
    return read;
}

} // namespace esm
