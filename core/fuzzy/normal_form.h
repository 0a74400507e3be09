#pragma once

#include "core/fuzzy/fuzzy_system.h"

#include <string>

namespace esm {

/// The same text for conditions of which one can be made from the other without changing what it computes:
/// by another order of parts, other brackets, NOT NOT, and, as far as the norms allow it, parts said twice
/// and NOT drawn into brackets.
std::string normalForm(const FuzzyCondition& condition, const FuzzyNorms& norms);

} // namespace esm
