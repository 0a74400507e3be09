#pragma once

#include "core/fuzzy/value_cells.h"

#include <optional>
#include <utility>
#include <vector>

namespace esm {

/// Values of some inputs, by index in rising order, that may be combined freely. An input that is not there
/// may have any value of its range.
using ValueBox = std::vector<std::pair<std::size_t, CellSet>>;

/// Where conditions hold, as boxes of values that are exact at the corners of the terms. Conditions whose
/// boxes would be too many are left out, so that whole systems are looked at in a moment.
class RuleReach {
public:
    /// More than nothing, or fully.
    enum class Degree { AboveZero, Full };

    /// Keeps a reference to the system. Precondition: it is valid.
    explicit RuleReach(const FuzzySystem& system);

    std::size_t inputs() const { return m_cells.size(); }
    const std::vector<ValueCell>& cells(std::size_t input) const { return m_cells[input]; }

    /// The condition reaches the degree where the values lie in any of the boxes. Empty where they would be
    /// too many. Exact for minimum and product, maximum and probabilistic sum; where bounded difference and
    /// bounded sum are among the norms, a condition may reach less than is said of AboveZero, and more than
    /// is said of Full, when it asks for one input several times or for a term whose core lies outside the
    /// range.
    std::optional<std::vector<ValueBox>> where(const FuzzyCondition& condition, Degree degree);

private:
    using Boxes = std::vector<ValueBox>;
    struct Wanted {
        Degree degree;
        bool isNegated;
    };
    struct TermCells {
        CellSet support, core;
    };

    Boxes boxesOf(const FuzzyCondition& condition, Wanted wanted);
    Boxes propositionBoxes(const FuzzyProposition& proposition, Wanted wanted) const;
    Boxes commonOf(const Boxes& one, const Boxes& other);
    void include(Boxes& boxes, const ValueBox& box);

    std::vector<std::vector<ValueCell>> m_cells;
    std::vector<std::vector<TermCells>> m_terms;
    std::size_t m_work = 0; ///< boxes compared so far
    bool m_isTooMuch = false;
};

/// Whether some values are in both.
bool meet(const ValueBox& one, const ValueBox& other);
bool isWithin(const ValueBox& inner, const ValueBox& outer);

/// The values in both; empty where there are none.
std::optional<ValueBox> commonPart(const ValueBox& one, const ValueBox& other);

} // namespace esm
