#pragma once

#include "core/fuzzy/fuzzy_system.h"

#include <string>
#include <vector>

namespace esm {

/// Something in a valid system that its author may not have meant.
struct SystemWarning {
    enum class Kind {
        NoRule,
        Contradiction,  ///< rules that hold fully at once and conclude different terms of one output
        NeverFires,     ///< a rule of weight 0, or whose condition cannot hold
        Duplicate,      ///< rules that say the same
        UncoveredRange, ///< values of an input for which no rule that asks for it can fire
        PartitionGap,   ///< values of an input that belong to no term
        EmptyOutput,    ///< values of inputs for which no rule that concludes an output fires
        UnusedTerm,
        UnusedVariable, ///< an input that no rule asks for, an output that no rule concludes
        NotChecked      ///< rules too intricate or too many to be compared, contradictions to be listed
    };

    Kind kind;
    std::string text;               ///< a sentence; rules are numbered from 1
    std::vector<std::size_t> rules; ///< that it speaks of, as indices
};

/// The most that are told of contradictions, which grow with the square of the rules.
inline constexpr std::size_t mostContradictions = 50;
/// Of combinations of inputs that leave an output empty, the most that are told; the widest are.
inline constexpr std::size_t mostEmptyCombinations = 5;

/// All of them, the gravest kinds first. Two rules contradict each other when they conclude different terms
/// of an output and their conditions are the same, or can hold fully at once and either ask for the same
/// inputs or one of them holds fully wherever the other does. Precondition: the system is valid.
std::vector<SystemWarning> systemWarnings(const FuzzySystem& system);

/// Whether it may bear on what comes out: all but terms that nothing uses.
inline bool bearsOnResults(const SystemWarning& warning) {
    return warning.kind != SystemWarning::Kind::UnusedTerm;
}

} // namespace esm
