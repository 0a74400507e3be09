#pragma once

#include "core/fuzzy/fuzzy_system.h"

#include <QMap>
#include <QPalette>
#include <QSet>
#include <QSyntaxHighlighter>

#include <vector>

namespace esm {

/// What a word of a rule is, as far as it can be told from the words before it.
enum class RuleWordKind { Keyword, Variable, Term, Number, Unknown };

struct RuleWordPlace {
    int start, length; ///< in a QString's units
    RuleWordKind kind;
};

/// The names that rules of a system are made of.
class RuleVocabulary {
public:
    RuleVocabulary() = default;
    explicit RuleVocabulary(const FuzzySystem& system);

    /// The words of a rule in order. A term is one of the variable that was named last.
    std::vector<RuleWordPlace> wordsOf(const QString& rule) const;
    bool operator==(const RuleVocabulary& other) const { return m_terms == other.m_terms; }

private:
    QMap<QString, QSet<QString>> m_terms; ///< by variable
};

/// A word's colour on a text field's ground; keywords are bold as well.
QTextCharFormat formatOf(RuleWordKind kind, const QPalette& palette);

/// Colours rules, one per line.
class RuleHighlighter : public QSyntaxHighlighter {
public:
    using QSyntaxHighlighter::QSyntaxHighlighter;

    void setVocabulary(const RuleVocabulary& vocabulary);
    void setPalette(const QPalette& palette);

protected:
    void highlightBlock(const QString& text) override;

private:
    RuleVocabulary m_vocabulary;
    QPalette m_palette;
};

} // namespace esm
