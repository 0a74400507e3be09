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

RegionsJson toJson(const std::vector<Region>& regions);

/// Regions that name the same system share it.
std::vector<Region> regionsFromJson(const JsonReader& systems, const JsonReader& regions);

} // namespace esm
