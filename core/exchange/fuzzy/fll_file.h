#pragma once

#include "core/exchange/fuzzy/fuzzy_file.h"
#include "core/support/file_io.h"

namespace esm {

/// FuzzyLite Language, as fuzzylite 5 and 6 write it. @throws InvalidModel with line and column
ImportedFuzzySystem fuzzySystemFromFll(const Bytes& content);

/// As fuzzylite 6 reads it. What the language has no words for stands in remarks that fuzzySystemFromFll()
/// reads. Precondition: the system is valid.
ExportedFuzzySystem toFll(const FuzzySystem& system);

} // namespace esm
