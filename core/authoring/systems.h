#pragma once

#include "core/project/project.h"

#include <string>

namespace esm {

/// Shared by regions that speak the same language.
using SharedSystem = std::shared_ptr<const FuzzySystem>;

/// Every fuzzy system of the project once: those of regions, from the lowest, then those that none uses.
std::vector<SharedSystem> systemsOf(const Project& project);

/// The regions that use a system, from the lowest. Systems that are alike are one.
std::vector<const Region*> usersOf(const Project& project, const FuzzySystem& system);

/// To be called when a region was given another system: the one it had stays in the project where no other
/// region uses it, and what is used again is no longer spare. Null where it had none.
void keepSystem(Project& project, const SharedSystem& former);

/// Takes a system that no region uses out of the project. Nothing where it is not there.
void removeSpareSystem(Project& project, const FuzzySystem& system);

/// What inputs are set to under another system: an input of the same name and unit keeps its value where its
/// range holds it, others start in the middle of their ranges.
NamedValues inputsUnder(const FuzzySystem& system, const FuzzySystem& before, const NamedValues& values);

} // namespace esm
