#include "widgets/fuzzy/rule_highlighter.h"

#include "core/fuzzy/keywords.h"

#include <tuple>

namespace esm {

namespace {

bool isBracketLetter(QChar c) {
    return c == '(' || c == ')';
}

/// Start and length of the word at or behind a place; of length 0 at the end.
std::pair<int, int> nextWord(const QString& text, int from) {
    while (from < text.size() && text[from] <= ' ')
        ++from;
    if (from < text.size() && isBracketLetter(text[from])) return {from, 1};
    int end = from;
    while (end < text.size() && text[end] > ' ' && !isBracketLetter(text[end]))
        ++end;
    return {from, end - from};
}

} // namespace

RuleVocabulary::RuleVocabulary(const FuzzySystem& system) {
    for (const auto* variables : {&system.inputs, &system.outputs})
        for (const FuzzyVariable& variable : *variables) {
            QSet<QString>& terms = m_terms[QString::fromStdString(variable.name)];
            for (const FuzzyTerm& term : variable.terms)
                terms.insert(QString::fromStdString(term.name));
        }
}

std::vector<RuleWordPlace> RuleVocabulary::wordsOf(const QString& rule) const {
    std::vector<RuleWordPlace> places;
    const QSet<QString>* terms = nullptr; // of the variable that was named last
    bool isTermNext = false;
    for (auto [start, length] = nextWord(rule, 0); length > 0;
         std::tie(start, length) = nextWord(rule, start + length)) {
        const QString word = rule.mid(start, length);
        const auto variable = m_terms.constFind(word);
        RuleWordKind kind = RuleWordKind::Unknown;
        if (isBracketLetter(word[0]) || isKeyword(word.toStdString())) {
            kind = RuleWordKind::Keyword;
            isTermNext =
                isKeyword(word.toStdString(), "IS") || (isTermNext && isKeyword(word.toStdString(), "NOT"));
        } else if (isTermNext) {
            if (terms && terms->contains(word)) kind = RuleWordKind::Term;
            isTermNext = false;
        } else if (variable != m_terms.constEnd()) {
            kind = RuleWordKind::Variable;
            terms = &*variable;
        } else {
            bool isNumber = false;
            word.toDouble(&isNumber);
            if (isNumber) kind = RuleWordKind::Number;
        }
        places.push_back({start, length, kind});
    }
    return places;
}

QTextCharFormat formatOf(RuleWordKind kind, const QPalette& palette) {
    QTextCharFormat format;
    const auto colour = [&](QPalette::ColorRole role) {
        format.setForeground(palette.color(QPalette::Active, role));
    };
    switch (kind) {
    case RuleWordKind::Keyword:
        colour(QPalette::PlaceholderText);
        format.setFontWeight(QFont::Bold);
        break;
    case RuleWordKind::Variable:
        colour(QPalette::Text);
        break;
    case RuleWordKind::Term:
        colour(QPalette::Link);
        break;
    case RuleWordKind::Number:
        colour(QPalette::LinkVisited);
        break;
    case RuleWordKind::Unknown:
        colour(QPalette::BrightText);
        break;
    }
    return format;
}

void RuleHighlighter::setVocabulary(const RuleVocabulary& vocabulary) {
    if (vocabulary == m_vocabulary) return;
    m_vocabulary = vocabulary;
    rehighlight();
}

void RuleHighlighter::setPalette(const QPalette& palette) {
    m_palette = palette;
    rehighlight();
}

void RuleHighlighter::highlightBlock(const QString& text) {
    for (const RuleWordPlace& word : m_vocabulary.wordsOf(text))
        setFormat(word.start, word.length, formatOf(word.kind, m_palette));
}

} // namespace esm
