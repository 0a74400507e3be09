#pragma once

#include "core/exchange/fuzzy/fuzzy_file.h"

#include <memory>

namespace esm {

/// What a new region speaks: words that rise in order, in units that clinicians know.
inline std::shared_ptr<const FuzzySystem> startingSystem() {
    return std::make_shared<const FuzzySystem>(fuzzyPreset("organ"));
}

} // namespace esm
