#pragma once

#include <vector>

namespace esm {

/// A file of `presets/`, compiled in.
struct EmbeddedPreset {
    const char* name; ///< the file's name without `.json`
    const char* json;
};

std::vector<EmbeddedPreset> embeddedFuzzyPresets();
std::vector<EmbeddedPreset> embeddedTissuePresets(); ///< of `presets/tissue/`

} // namespace esm
