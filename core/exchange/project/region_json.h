#pragma once

#include "core/project/region.h"
#include "core/support/json_reader.h"

#include <memory>
#include <vector>

namespace esm {

/// Regions as the project file and the model package hold them: each distinct fuzzy system once, and the
/// regions naming theirs by its place in the list.
struct RegionsJson {
    nlohmann::ordered_json systems = nlohmann::ordered_json::array();
    nlohmann::ordered_json regions = nlohmann::ordered_json::array();
};

using Systems = std::vector<ByValue<FuzzySystem>>;

/// @param spare systems that no region names; those that ship with the program are left out
RegionsJson toJson(const std::vector<Region>& regions, const Systems& spare = {});

struct ReadRegions {
    std::vector<Region> regions; ///< those that name the same system share it
    Systems spare;               ///< each once; none of what ships with the program
};

ReadRegions regionsFromJson(const JsonReader& systems, const JsonReader& regions);

} // namespace esm
