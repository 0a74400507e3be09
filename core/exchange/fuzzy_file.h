#pragma once

#include "core/fuzzy/fuzzy_system.h"

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace esm {

/// The order of variables and terms in the JSON is meaningful and kept both ways.
FuzzySystem fuzzySystemFromJson(const nlohmann::ordered_json& json); ///< @throws InvalidModel
nlohmann::ordered_json toJson(const FuzzySystem& system);

FuzzySystem readFuzzyFile(const std::filesystem::path& file); ///< @throws FileError
void writeFuzzyFile(const FuzzySystem& system, const std::filesystem::path& file); ///< @throws FileError

/// The systems that ship with the program, compiled in from `presets/`.
std::vector<std::string> fuzzyPresetNames();
FuzzySystem fuzzyPreset(const std::string& name); ///< @throws InvalidModel naming the presets there are

} // namespace esm
