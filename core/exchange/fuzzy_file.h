#pragma once

#include "core/fuzzy/fuzzy_system.h"

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace esm {

/// Systems in the form of `presets/*.json`. The order of variables and terms in the JSON is meaningful and
/// kept both ways. Keys of another name are ignored: a newer program may have written them.
FuzzySystem fuzzySystemFromJson(const nlohmann::ordered_json& json); ///< @throws InvalidModel
nlohmann::ordered_json toJson(const FuzzySystem& system);

/// What a user wrote: keys of another name are refused, so that a misspelt one is not lost. A system without
/// a name takes the file's. @throws FileError
FuzzySystem readFuzzyFile(const std::filesystem::path& file);

/// The systems that ship with the program, compiled in from `presets/`.
std::vector<std::string> fuzzyPresetNames();
FuzzySystem fuzzyPreset(const std::string& name); ///< @throws InvalidModel naming the presets there are
/// Whether it is what ships under its name, whatever it says about itself: a file may name its system alike,
/// and a project may hold the preset as an older program described it.
bool isFuzzyPreset(const FuzzySystem& system);

/// What a user calls a system: a preset's name, else a file. @throws InvalidModel, FileError
FuzzySystem findFuzzySystem(const std::string& fileOrPreset);

} // namespace esm
