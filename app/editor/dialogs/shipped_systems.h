#pragma once

#include "core/fuzzy/fuzzy_system.h"

#include <QString>

#include <memory>
#include <vector>

namespace esm {

/// The systems that ship with the program, read once.
const std::vector<std::shared_ptr<const FuzzySystem>>& shippedSystems();

/// The one that ships under this name; null where none does.
std::shared_ptr<const FuzzySystem> shippedSystem(const std::string& name);

/// Whether a system is what ships under its name, whatever it says about itself, as isFuzzyPreset() has it.
bool isShipped(const FuzzySystem& system);

/// A system's name for people: one that was changed does not pass for the shipped one whose name it bears.
QString shownName(const FuzzySystem& system);

} // namespace esm
