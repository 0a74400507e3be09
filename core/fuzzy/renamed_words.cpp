#include "core/fuzzy/renamed_words.h"

#include "core/fuzzy/rule_words.h"

#include <algorithm>

namespace esm {

namespace {

template<class Named> bool hasName(const std::vector<Named>& list, const std::string& name) {
    return std::any_of(list.begin(), list.end(), [&](const Named& entry) { return entry.name == name; });
}

/// The place of what is called so; the list's size where nothing is.
template<class Named> std::size_t placeOf(const std::vector<Named>& list, const std::string& name) {
    const auto found = std::find_if(list.begin(), list.end(), [&](const Named& e) { return e.name == name; });
    return static_cast<std::size_t>(found - list.begin());
}

/// The entry of that name or, where it was renamed, the one that took its place. An entry counts as renamed
/// where the list is as long as before, the old name is gone, and what stands at its place has a name that is
/// new. Null where that cannot be told. Text that is no rule yet does not say which variable a word means, so
/// that a renaming is read off the two systems.
template<class Named>
const Named* successorOf(const std::vector<Named>& before, const std::vector<Named>& after,
                         const std::string& name) {
    const std::size_t place = placeOf(before, name);
    if (place == before.size()) return nullptr;
    if (const std::size_t kept = placeOf(after, name); kept < after.size()) return &after[kept];
    if (before.size() != after.size() || hasName(before, after[place].name)) return nullptr;
    return &after[place];
}

/// A variable as it was and as it is.
struct Followed {
    const FuzzyVariable *before = nullptr, *after = nullptr;
};

Followed variableOf(const FuzzySystem& before, const FuzzySystem& after, const std::string& name) {
    using Variables = std::vector<FuzzyVariable> FuzzySystem::*;
    for (const Variables list : {&FuzzySystem::inputs, &FuzzySystem::outputs})
        if (const FuzzyVariable* successor = successorOf(before.*list, after.*list, name))
            return {&(before.*list)[placeOf(before.*list, name)], successor};
    return {};
}

} // namespace

/// Word by word and not by reading the rule: a line that is being typed is no rule yet, and must keep its
/// names as others do. Terms are those of the variable that was named last.
std::string withNamesOf(const FuzzySystem& after, const FuzzySystem& before, const std::string& line) {
    std::string renamed;
    std::size_t copied = 0;
    Followed variable; // that terms are spoken of
    for (const RuleWord& word : ruleWords(line)) {
        const std::string* name = nullptr;
        if (const Followed named = variableOf(before, after, word.text); named.after) {
            variable = named;
            name = &named.after->name;
        } else if (variable.after) {
            const FuzzyTerm* term = successorOf(variable.before->terms, variable.after->terms, word.text);
            name = term ? &term->name : nullptr;
        }
        if (!name) continue;
        renamed += line.substr(copied, word.begin - copied) + *name;
        copied = word.begin + word.text.size();
    }
    return renamed + line.substr(copied);
}

} // namespace esm
