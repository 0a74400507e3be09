#include "core/exchange/fuzzy/fuzzy_identifiers.h"

#include "core/exchange/fuzzy/fuzzy_source.h"
#include "core/support/joined.h"
#include "core/support/letters.h"

#include <set>

namespace esm {

namespace {

/// Tells names apart by their letters whatever their case, as IEC 61131 does.
class Identifiers {
public:
    explicit Identifiers(const std::vector<TextWord>& reserved) {
        for (const TextWord& word : reserved)
            m_taken.insert(word.text);
    }

    std::string next(const std::string& name) {
        const std::string plain = identifierFor(name);
        std::string identifier = plain;
        for (int count = 2; !m_taken.insert(inSmallLetters(identifier)).second; ++count)
            identifier = plain + "_" + std::to_string(count);
        return identifier;
    }

private:
    std::set<std::string> m_taken;
};

void identify(std::string& name, Identifiers& identifiers, std::vector<std::string>& changes) {
    const std::string identifier = identifiers.next(name);
    if (identifier != name) changes.push_back(name + " as " + identifier);
    name = identifier;
}

} // namespace

std::string identifierFor(const std::string& name) {
    constexpr std::size_t longest = 100; // other programs, and our own readers, refuse words without end
    std::string identifier;
    for (const char c : name) {
        if (identifier.size() == longest) break;
        const bool isDigit = c >= '0' && c <= '9';
        const bool isLetter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
        if (isDigit && identifier.empty()) identifier += '_';
        if (isDigit || isLetter)
            identifier += c;
        else if (startsLetter(c)) // one for each letter
            identifier += '_';
    }
    return identifier.empty() ? "unnamed" : identifier;
}

bool isIdentifierOf(const std::string& identifier, const std::string& name) {
    const std::string plain = identifierFor(name);
    if (identifier.compare(0, plain.size(), plain) != 0) return false;
    const std::string number = identifier.substr(plain.size());
    return number.empty() ||
           (number.front() == '_' && number.find_first_not_of("0123456789", 1) == number.npos);
}

IdentifiedSystem withIdentifiers(const FuzzySystem& system, const std::string& reservedWords) {
    const std::vector<TextWord> reserved = textWords(reservedWords, {}, "");
    IdentifiedSystem result{system, {}};
    std::vector<std::string> changes;
    Identifiers variables(reserved);
    for (auto* list : {&result.system.inputs, &result.system.outputs})
        for (FuzzyVariable& variable : *list) {
            identify(variable.name, variables, changes);
            Identifiers terms(reserved);
            for (FuzzyTerm& term : variable.terms)
                identify(term.name, terms, changes);
        }
    if (!changes.empty())
        result.warnings.push_back("names are written otherwise, with a remark that says what they are: " +
                                  joined(changes));
    return result;
}

} // namespace esm
