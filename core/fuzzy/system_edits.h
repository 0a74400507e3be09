#pragma once

#include "core/fuzzy/fuzzy_system.h"

#include <string>
#include <vector>

/// Edits of a fuzzy system. Each gives a valid system or throws InvalidModel with the reason in plain words.
/// Rules name variables and terms by their places, so that they follow where something is renamed; where
/// something is moved, their places are put right and they mean what they did.
/// Preconditions: the system is valid, and places are those of variables and terms that are there.
namespace esm {

enum class FuzzySide { Inputs, Outputs };

/// A variable of a system.
struct VariablePlace {
    FuzzySide side = FuzzySide::Inputs;
    std::size_t index = 0;

    bool operator==(const VariablePlace&) const = default;
};

const std::vector<FuzzyVariable>& variablesOf(const FuzzySystem& system, FuzzySide side);
const FuzzyVariable& variableAt(const FuzzySystem& system, const VariablePlace& place);

/// A name that people typed, as rules write it: "very soft" becomes "very_soft".
std::string ruleName(const std::string& typed);

FuzzySystem withVariableRenamed(FuzzySystem system, const VariablePlace& place, const std::string& name);
FuzzySystem withTermRenamed(FuzzySystem system, const VariablePlace& place, std::size_t term,
                            const std::string& name);

/// Another form of a variable: its range, its unit, the sets of its terms. Precondition: it has the same
/// terms by name and order.
FuzzySystem withVariable(FuzzySystem system, const VariablePlace& place, FuzzyVariable variable);

FuzzySystem withTermMoved(FuzzySystem system, const VariablePlace& place, std::size_t from, std::size_t to);
/// Within its side.
FuzzySystem withVariableMoved(FuzzySystem system, const VariablePlace& place, std::size_t to);

/// What was added, and where.
struct AddedTerm {
    FuzzySystem system;
    std::size_t term;
};

/// A term of an unused name in the widest gap between the cores of the others, behind the term at the gap's
/// lower end.
AddedTerm withTermAdded(FuzzySystem system, const VariablePlace& place);

/// Another variable of an unused name at the end of its side, evenly parted into three terms.
FuzzySystem withVariableAdded(FuzzySystem system, FuzzySide side);

/// The rules that would go with a term or a variable, since their condition speaks of it or all they conclude
/// is about it.
std::vector<std::size_t> rulesGoingWith(const FuzzySystem& system, const VariablePlace& place);
std::vector<std::size_t> rulesGoingWith(const FuzzySystem& system, const VariablePlace& place,
                                        std::size_t term);

/// Without it and the rules that go with it; of the others' conclusions those about it are taken out. The
/// last one cannot be removed.
FuzzySystem withoutVariable(FuzzySystem system, const VariablePlace& place);
FuzzySystem withoutTerm(FuzzySystem system, const VariablePlace& place, std::size_t term);

/// A system to begin with: a word for how firm the tissue is, the spring constant and viscosity it comes to,
/// and no rule yet.
FuzzySystem newFuzzySystem(const std::string& name);

} // namespace esm
