#pragma once

#include "core/fuzzy/fuzzy_system.h"

namespace esm {

/// A line of a rule's text with the names that variables and terms have got since, word by word, so that what
/// cannot be read as a rule follows too. Where the systems have other variables or terms than the same under
/// other names, their words stay.
std::string withNamesOf(const FuzzySystem& after, const FuzzySystem& before, const std::string& line);

} // namespace esm
