#pragma once

#include "core/fuzzy/fuzzy_system.h"

#include <string>
#include <vector>

namespace esm {

/// A system under names that other languages take: letters from a to z, digits and _. Variables and terms are
/// in the order of the original.
struct IdentifiedSystem {
    FuzzySystem system;
    std::vector<std::string> warnings; ///< which names are written otherwise
};

/// @param reserved words that no name may be, in small letters, between blanks
IdentifiedSystem withIdentifiers(const FuzzySystem& system, const std::string& reserved);

/// The name of a whole system as such a name.
std::string identifierFor(const std::string& name);

/// Whether a name may have become this identifier. A remark of somebody else may look like one of ours.
bool isIdentifierOf(const std::string& identifier, const std::string& name);

} // namespace esm
