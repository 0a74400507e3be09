#pragma once

#include "core/fuzzy/fuzzy_system.h"

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace esm {

/// Systems in the form of `presets/*.json`. The order of variables and terms in the JSON is meaningful and
/// kept both ways. Keys of another name are refused, so that a misspelt one is not lost.
FuzzySystem fuzzySystemFromJson(const nlohmann::ordered_json& json); ///< @throws InvalidModel
nlohmann::ordered_json toJson(const FuzzySystem& system);

/// A system without a name takes the file's. @throws FileError
FuzzySystem readFuzzyFile(const std::filesystem::path& file);

/// The systems that ship with the program, compiled in from `presets/`.
std::vector<std::string> fuzzyPresetNames();
FuzzySystem fuzzyPreset(const std::string& name); ///< @throws InvalidModel naming the presets there are

/// What a user calls a system: a preset's name, else a file. @throws InvalidModel, FileError
FuzzySystem findFuzzySystem(const std::string& fileOrPreset);

} // namespace esm
