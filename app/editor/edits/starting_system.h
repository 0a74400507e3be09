#pragma once

#include "core/exchange/fuzzy/fuzzy_file.h"

#include <memory>

namespace esm {

/// What a new region speaks: the simplest of the systems that ship.
inline std::shared_ptr<const FuzzySystem> startingSystem() {
    return std::make_shared<const FuzzySystem>(fuzzyPreset("susilap-g"));
}

} // namespace esm
