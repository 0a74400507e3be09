#include "core/fuzzy/system_edits.h"

#include "core/fuzzy/keywords.h"
#include "core/fuzzy/partition_edits.h"
#include "core/support/errors.h"

#include <algorithm>
#include <functional>
#include <optional>

namespace esm {

namespace {

using Variables = std::vector<FuzzyVariable>;

Variables& listOf(FuzzySystem& system, FuzzySide side) {
    return side == FuzzySide::Inputs ? system.inputs : system.outputs;
}

/// Every edit ends here: what it gives can be evaluated, or it throws and nothing was edited.
FuzzySystem checked(FuzzySystem system) {
    if (auto problems = validate(system); !problems.empty()) throw InvalidModel(std::move(problems));
    return system;
}

template<class List> bool isNameOf(const List& things, const std::string& name) {
    return std::any_of(things.begin(), things.end(), [&](const auto& thing) { return thing.name == name; });
}

bool isVariable(const FuzzySystem& system, const std::string& name) {
    return isNameOf(system.inputs, name) || isNameOf(system.outputs, name);
}

/// "word", or with the first number behind it that makes it unused.
template<class IsUsed> std::string unusedName(const std::string& word, const IsUsed& isUsed) {
    std::string name = word;
    for (int number = 2; isUsed(name); ++number)
        name = word + "_" + std::to_string(number);
    return name;
}

void throwIfNoName(const std::string& name) {
    if (const std::string problem = nameProblem(name); !problem.empty()) throw InvalidModel(problem);
}

/// What becomes of "variable IS term" on one side; none where it can no longer be said.
///
/// Rules speak of variables and terms by their places in lists. So every edit of a list is the same edit of
/// the rules with another map from old places to new ones, and a rule that speaks of what is gone goes with
/// it. Rules by name would survive the edit, but then each inference would have to look names up.
using Remap = std::function<std::optional<FuzzyProposition>(const FuzzyProposition&)>;

/// False where the condition speaks of what is gone.
bool remap(FuzzyCondition& condition, const Remap& goesTo) {
    if (condition.kind == FuzzyCondition::Kind::Is) {
        const auto now = goesTo(condition.proposition);
        if (now) condition.proposition = *now;
        return now.has_value();
    }
    return std::all_of(condition.parts.begin(), condition.parts.end(),
                       [&](FuzzyCondition& part) { return remap(part, goesTo); });
}

/// False where no conclusion is left.
bool remap(std::vector<FuzzyProposition>& conclusions, const Remap& goesTo) {
    std::vector<FuzzyProposition> left;
    for (const FuzzyProposition& conclusion : conclusions)
        if (const auto now = goesTo(conclusion)) left.push_back(*now);
    conclusions = std::move(left);
    return !conclusions.empty();
}

bool remap(FuzzyRule& rule, FuzzySide side, const Remap& goesTo) {
    return side == FuzzySide::Inputs ? remap(rule.condition, goesTo) : remap(rule.conclusions, goesTo);
}

void remapRules(FuzzySystem& system, FuzzySide side, const Remap& goesTo) {
    std::vector<FuzzyRule> left;
    for (FuzzyRule& rule : system.rules)
        if (remap(rule, side, goesTo)) left.push_back(std::move(rule));
    system.rules = std::move(left);
}

/// Tried on copies: what the window tells before an edit is exactly what the edit does.
std::vector<std::size_t> rulesLost(const FuzzySystem& system, FuzzySide side, const Remap& goesTo) {
    std::vector<std::size_t> lost;
    for (std::size_t i = 0; i < system.rules.size(); ++i) {
        FuzzyRule rule = system.rules[i];
        if (!remap(rule, side, goesTo)) lost.push_back(i);
    }
    return lost;
}

/// Where a member of a list stands after one of them was moved.
std::size_t afterMove(std::size_t index, std::size_t from, std::size_t to) {
    if (index == from) return to;
    if (from < index && index <= to) return index - 1;
    if (to <= index && index < from) return index + 1;
    return index;
}

std::optional<std::size_t> afterRemoval(std::size_t index, std::size_t removed) {
    if (index == removed) return std::nullopt;
    return index > removed ? index - 1 : index;
}

/// What lies between both places moves up by one, as in a list that is reordered by hand.
template<class List> void move(List& list, std::size_t from, std::size_t to) {
    const auto at = [&](std::size_t index) { return list.begin() + static_cast<std::ptrdiff_t>(index); };
    if (from < to)
        std::rotate(at(from), at(from + 1), at(to + 1));
    else
        std::rotate(at(to), at(from), at(from + 1));
}

Remap withoutVariableAt(std::size_t removed) {
    return [removed](const FuzzyProposition& said) -> std::optional<FuzzyProposition> {
        const auto variable = afterRemoval(said.variable, removed);
        return variable ? std::optional(FuzzyProposition{*variable, said.term}) : std::nullopt;
    };
}

Remap withoutTermAt(std::size_t variable, std::size_t removed) {
    return [=](const FuzzyProposition& said) -> std::optional<FuzzyProposition> {
        if (said.variable != variable) return said;
        const auto term = afterRemoval(said.term, removed);
        return term ? std::optional(FuzzyProposition{variable, *term}) : std::nullopt;
    };
}

/// A stretch of a range between two cores, and the place in the list of a term that fills it.
struct Gap {
    double from, to;
    std::size_t place;

    double width() const { return to - from; }
};

/// Goes over the cores from left to right, as one lays out overlapping intervals: what none of them has
/// covered so far up to the next beginning is a gap. Cores and not whole terms, since flanks overlap where
/// partitions are good.
Gap widestGap(const FuzzyVariable& variable) {
    std::vector<std::size_t> rising(variable.terms.size());
    for (std::size_t i = 0; i < rising.size(); ++i)
        rising[i] = i;
    std::stable_sort(rising.begin(), rising.end(), [&](std::size_t one, std::size_t other) {
        return variable.terms[one].set.b < variable.terms[other].set.b;
    });
    Gap widest{variable.minimum, variable.minimum, 0}, next = widest;
    const auto endAt = [&](double place) {
        next.to = std::min(place, variable.maximum);
        if (next.width() > widest.width()) widest = next;
    };
    for (const std::size_t term : rising) {
        endAt(variable.terms[term].set.b);
        next.from = std::max(next.from, variable.terms[term].set.c);
        next.place = term + 1;
    }
    endAt(variable.maximum);
    return widest.width() > 0 ? widest : Gap{variable.minimum, variable.maximum, rising.size()};
}

FuzzyVariable threeTerms(const std::string& name, double maximum, const std::string& unit = {}) {
    FuzzyVariable variable{name, 0, maximum, {{"small", {}}, {"medium", {}}, {"large", {}}}, unit};
    variable.terms = evenPartition(variable);
    return variable;
}

} // namespace

const std::vector<FuzzyVariable>& variablesOf(const FuzzySystem& system, FuzzySide side) {
    return side == FuzzySide::Inputs ? system.inputs : system.outputs;
}

const FuzzyVariable& variableAt(const FuzzySystem& system, const VariablePlace& place) {
    return variablesOf(system, place.side)[place.index];
}

/// People type "spring constant" where rules need one word. Spaces at the ends are slips and go.
std::string ruleName(const std::string& typed) {
    std::string name;
    bool isGap = false;
    for (const char c : typed) {
        if (c == ' ' || c == '\t') {
            isGap = !name.empty();
            continue;
        }
        if (isGap) name += '_';
        isGap = false;
        name += c;
    }
    return name;
}

FuzzySystem withVariableRenamed(FuzzySystem system, const VariablePlace& place, const std::string& name) {
    FuzzyVariable& variable = listOf(system, place.side)[place.index];
    if (variable.name == name) return system;
    throwIfNoName(name);
    if (isVariable(system, name)) throw InvalidModel("there is a variable \"" + name + "\" already");
    variable.name = name;
    return checked(std::move(system));
}

FuzzySystem withTermRenamed(FuzzySystem system, const VariablePlace& place, std::size_t term,
                            const std::string& name) {
    FuzzyVariable& variable = listOf(system, place.side)[place.index];
    if (variable.terms[term].name == name) return system;
    throwIfNoName(name);
    if (isNameOf(variable.terms, name))
        throw InvalidModel("\"" + variable.name + "\" has a term \"" + name + "\" already");
    variable.terms[term].name = name;
    return checked(std::move(system));
}

FuzzySystem withVariable(FuzzySystem system, const VariablePlace& place, FuzzyVariable variable) {
    listOf(system, place.side)[place.index] = std::move(variable);
    return checked(std::move(system));
}

FuzzySystem withTermMoved(FuzzySystem system, const VariablePlace& place, std::size_t from, std::size_t to) {
    move(listOf(system, place.side)[place.index].terms, from, to);
    remapRules(system, place.side, [&](const FuzzyProposition& said) {
        return std::optional(said.variable == place.index
                                 ? FuzzyProposition{said.variable, afterMove(said.term, from, to)}
                                 : said);
    });
    return checked(std::move(system));
}

FuzzySystem withVariableMoved(FuzzySystem system, const VariablePlace& place, std::size_t to) {
    move(listOf(system, place.side), place.index, to);
    remapRules(system, place.side, [&](const FuzzyProposition& said) {
        return std::optional(FuzzyProposition{afterMove(said.variable, place.index, to), said.term});
    });
    return checked(std::move(system));
}

/// Into the widest gap between two cores: flanks over the outer thirds, a core over the middle one. It meets
/// both neighbours and leaves their cores alone.
AddedTerm withTermAdded(FuzzySystem system, const VariablePlace& place) {
    FuzzyVariable& variable = listOf(system, place.side)[place.index];
    const Gap gap = widestGap(variable);
    const std::string name =
        unusedName("new", [&](const std::string& used) { return isNameOf(variable.terms, used); });
    const double third = gap.width() / 3;
    variable.terms.push_back({name, {gap.from, gap.from + third, gap.to - third, gap.to}});
    const std::size_t last = variable.terms.size() - 1;
    return {withTermMoved(std::move(system), place, last, gap.place), gap.place};
}

FuzzySystem withVariableAdded(FuzzySystem system, FuzzySide side) {
    const std::string name =
        unusedName("variable", [&](const std::string& used) { return isVariable(system, used); });
    listOf(system, side).push_back(threeTerms(name, 10));
    return checked(std::move(system));
}

std::vector<std::size_t> rulesGoingWith(const FuzzySystem& system, const VariablePlace& place) {
    return rulesLost(system, place.side, withoutVariableAt(place.index));
}

std::vector<std::size_t> rulesGoingWith(const FuzzySystem& system, const VariablePlace& place,
                                        std::size_t term) {
    return rulesLost(system, place.side, withoutTermAt(place.index, term));
}

FuzzySystem withoutVariable(FuzzySystem system, const VariablePlace& place) {
    Variables& variables = listOf(system, place.side);
    if (variables.size() == 1)
        throw InvalidModel(place.side == FuzzySide::Inputs ? "a system has at least one input"
                                                           : "a system has at least one output");
    variables.erase(variables.begin() + static_cast<std::ptrdiff_t>(place.index));
    remapRules(system, place.side, withoutVariableAt(place.index));
    return checked(std::move(system));
}

FuzzySystem withoutTerm(FuzzySystem system, const VariablePlace& place, std::size_t term) {
    FuzzyVariable& variable = listOf(system, place.side)[place.index];
    if (variable.terms.size() == 1) throw InvalidModel("a variable has at least one term");
    variable.terms.erase(variable.terms.begin() + static_cast<std::ptrdiff_t>(term));
    remapRules(system, place.side, withoutTermAt(place.index, term));
    return checked(std::move(system));
}

/// Without rules, but with words to write some: the outputs carry the names by which a region takes them for
/// its tissue.
FuzzySystem newFuzzySystem(const std::string& name) {
    FuzzySystem system;
    system.name = name;
    FuzzyVariable consistency = threeTerms("consistency", 10);
    consistency.terms[0].name = "soft";
    consistency.terms[2].name = "firm";
    system.inputs.push_back(std::move(consistency));
    system.outputs = {threeTerms("spring_constant", 100, "N/m"), threeTerms("viscosity", 20, "N·s/m")};
    return system;
}

} // namespace esm
