#pragma once

#include "core/exchange/fuzzy/fuzzy_draft.h"

namespace esm {

/// FCL does not care for the case of names: rules take the one of the declarations.
void takeDeclaredCase(FuzzyDraft& draft);

} // namespace esm
