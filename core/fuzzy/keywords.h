#pragma once

#include <string>

namespace esm {

/// Whether a word of a rule is the keyword, in any case. `keyword` is in capitals.
bool isKeyword(const std::string& word, const char* keyword);

/// Whether it is any of IF, IS, AND and THEN.
bool isKeyword(const std::string& word);

} // namespace esm
