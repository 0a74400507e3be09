#include "core/exchange/fuzzy/fcl_names.h"

#include "core/fuzzy/keywords.h"

#include <map>
#include <set>

namespace esm {

namespace {

/// Names that stand in one place of a rule.
class DeclaredNames {
public:
    void add(const std::string& name) {
        m_names.insert(name);
        m_byLetters.emplace(inSmallLetters(name), name);
    }

    /// The word itself where it is declared so, or not at all.
    std::string declared(const std::string& word) const {
        if (m_names.count(word) > 0) return word;
        const auto found = m_byLetters.find(inSmallLetters(word));
        return found == m_byLetters.end() ? word : found->second;
    }

private:
    std::set<std::string> m_names;
    std::map<std::string, std::string> m_byLetters;
};

/// Inputs, or outputs, with their terms.
struct DeclaredVariables {
    explicit DeclaredVariables(const std::vector<DraftVariable>& variables) {
        for (const DraftVariable& variable : variables) {
            const std::string& name = variable.name.identifier.text;
            names.add(name);
            for (const DraftTerm& term : variable.terms)
                terms[name].add(term.name.identifier.text);
        }
    }

    DeclaredNames names;
    std::map<std::string, DeclaredNames> terms;
};

void takeDeclaredCase(DraftRule& rule, const DeclaredVariables& inputs, const DeclaredVariables& outputs) {
    const DeclaredVariables* variables = &inputs;
    std::string variable;
    bool isTermNext = false;
    for (TextWord& word : rule.words) {
        if (isKeyword(word.text, "THEN")) variables = &outputs;
        if (isKeyword(word.text, "IS")) isTermNext = true;
        if (isKeyword(word.text)) continue;
        if (!isTermNext) {
            word.text = variable = variables->names.declared(word.text);
        } else if (const auto terms = variables->terms.find(variable); terms != variables->terms.end()) {
            word.text = terms->second.declared(word.text);
        }
        isTermNext = false;
    }
}

} // namespace

void takeDeclaredCase(FuzzyDraft& draft) {
    const DeclaredVariables inputs(draft.inputs), outputs(draft.outputs);
    for (DraftRule& rule : draft.rules)
        takeDeclaredCase(rule, inputs, outputs);
}

} // namespace esm
