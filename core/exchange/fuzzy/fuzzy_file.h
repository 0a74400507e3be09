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

/// A system from a file, and what of the file could not be taken as it stands there.
struct ImportedFuzzySystem {
    FuzzySystem system;
    std::vector<std::string> warnings; ///< each with line and column
};

/// The text of a file, and what the language of the file has no words for.
struct ExportedFuzzySystem {
    std::string text;
    std::vector<std::string> warnings;
};

/// What a user wrote, by the file's ending: FCL (`.fcl`), FLL (`.fll`), else JSON. In JSON keys of another
/// name are refused, so that a misspelt one is not lost. A system without a name takes the file's.
/// @throws FileError
ImportedFuzzySystem importFuzzyFile(const std::filesystem::path& file);

/// Whether the ending is `.json`, `.fcl` or `.fll`, in any case.
bool isFuzzyFileName(const std::filesystem::path& file);

/// In the language that the file's ending says: `.fcl`, `.fll`, else JSON. Precondition: the system is valid.
ExportedFuzzySystem exportFuzzySystem(const FuzzySystem& system, const std::filesystem::path& file);

/// The systems that ship with the program, compiled in from `presets/`.
std::vector<std::string> fuzzyPresetNames();
FuzzySystem fuzzyPreset(const std::string& name); ///< @throws InvalidModel naming the presets there are
/// Whether it is what ships under its name, whatever it says about itself: a file may name its system alike,
/// and a project may hold the preset as an older program described it.
bool isFuzzyPreset(const FuzzySystem& system);

/// What a user calls a system: a preset's name, else a file. @throws InvalidModel, FileError
ImportedFuzzySystem findFuzzySystem(const std::string& fileOrPreset);

} // namespace esm
