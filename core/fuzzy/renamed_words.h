#pragma once

#include "core/fuzzy/fuzzy_system.h"

namespace esm {

/// A line of a rule's text in which words of `before` are replaced by the names that the same variables and
/// terms have in `after`. The line need not be a rule yet. Words stay as they are where more than names has
/// changed.
std::string withNamesOf(const FuzzySystem& after, const FuzzySystem& before, const std::string& line);

} // namespace esm
