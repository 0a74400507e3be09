#pragma once

#include "core/exchange/fuzzy/fuzzy_source.h"

namespace esm {

/// The words of an FCL text one after the other, and the remarks between them. What cannot be read throws
/// InvalidModel with its place.
class FclWords {
public:
    explicit FclWords(const std::string& text);

    const TextWord& word() const { return m_words[m_next]; } ///< the next one; empty at the end
    bool isAtEnd() const { return word().text.empty(); }
    bool is(const char* keyword) const;
    bool isMark() const;

    bool accept(const char* keyword);
    void expect(const char* keyword);
    [[noreturn]] void fail(const std::string& expected) const;

    TextWord skip() { return m_words[m_next++]; } ///< whatever it is; precondition: not at the end
    TextWord take(const char* expected);          ///< a name, a number or a word of the language
    TextWord named();                             ///< ": name ;"
    std::vector<TextWord> statement();            ///< what is left of one

    /// What stands on the line of the word before, up to one of the keywords.
    std::string restOfLine(const std::vector<const char*>& keywords);

    /// Of remarks that were not asked for before: those beside what was read from `begin` on, on its last
    /// line.
    std::vector<TextRemark> remarksBeside(const TextPlace& begin);
    const std::vector<TextRemark>& remarks() const { return m_remarks; }

private:
    std::vector<TextWord> m_words; ///< the last one is empty and stands for the end
    std::vector<TextRemark> m_remarks;
    std::size_t m_next = 0, m_nextRemark = 0;
};

} // namespace esm
