#pragma once

#include "core/exchange/fuzzy/fuzzy_file.h"
#include "core/support/file_io.h"

namespace esm {

/// Fuzzy Control Language of IEC 61131-7, and what fuzzylite and jFuzzyLogic make of it.
/// @throws InvalidModel with line and column
ImportedFuzzySystem fuzzySystemFromFcl(const Bytes& content);

/// What the language has no words for stands in remarks that fuzzySystemFromFcl() reads.
/// Precondition: the system is valid.
ExportedFuzzySystem toFcl(const FuzzySystem& system);

} // namespace esm
