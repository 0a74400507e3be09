#include "core/fuzzy/rule_words.h"

#include "core/fuzzy/keywords.h"
#include "core/support/letters.h"

namespace esm {

/// Columns count letters and not bytes, as the reader of a message counts: continuation bytes of UTF-8 start
/// none. A bracket ends a word and is one; the last word is empty and stands at the end, so that "the rule
/// ends" has a place.
std::vector<RuleWord> ruleWords(const std::string& text) {
    std::vector<RuleWord> words;
    std::size_t column = 0;
    bool inWord = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (startsLetter(c)) ++column;
        if (static_cast<unsigned char>(c) <= ' ') {
            inWord = false;
            continue;
        }
        if (!inWord || isBracket(c)) words.push_back({"", i, column, 0});
        words.back().text += c;
        if (startsLetter(c)) ++words.back().length;
        inWord = !isBracket(c);
    }
    words.push_back({"", text.size(), column + 1, 0});
    return words;
}

} // namespace esm
