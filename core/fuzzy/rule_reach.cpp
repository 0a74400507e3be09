#include "core/fuzzy/rule_reach.h"

#include <algorithm>

namespace esm {

namespace {

constexpr std::size_t mostBoxes = 200;         // of one condition
constexpr std::size_t mostBoxWork = 3'000'000; // comparisons of boxes for one system

const CellSet* setOf(const ValueBox& box, std::size_t input) {
    const auto found =
        std::find_if(box.begin(), box.end(), [&](const auto& entry) { return entry.first == input; });
    return found == box.end() ? nullptr : &found->second;
}

/// Makes one box of two that differ in one input at most, which is both together without anything besides.
bool mergeInto(ValueBox& box, const ValueBox& other) {
    if (box.size() != other.size()) return false;
    std::size_t differing = box.size();
    for (std::size_t i = 0; i < box.size(); ++i) {
        if (box[i].first != other[i].first) return false;
        if (box[i].second == other[i].second) continue;
        if (differing < box.size()) return false;
        differing = i;
    }
    if (differing == box.size()) return true;
    CellSet& set = box[differing].second;
    set.unite(other[differing].second);
    if (set.isWhole()) box.erase(box.begin() + static_cast<std::ptrdiff_t>(differing));
    return true;
}

} // namespace

bool meet(const ValueBox& one, const ValueBox& other) {
    return std::all_of(other.begin(), other.end(), [&](const auto& entry) {
        const CellSet* set = setOf(one, entry.first);
        return !set || set->meets(entry.second);
    });
}

bool isWithin(const ValueBox& inner, const ValueBox& outer) {
    return std::all_of(outer.begin(), outer.end(), [&](const auto& entry) {
        const CellSet* set = setOf(inner, entry.first);
        return set && set->isWithin(entry.second);
    });
}

/// Both boxes have their inputs in rising order, and are gone through side by side.
std::optional<ValueBox> commonPart(const ValueBox& one, const ValueBox& other) {
    ValueBox common;
    auto left = one.begin();
    for (const auto& [input, set] : other) {
        for (; left != one.end() && left->first < input; ++left)
            common.push_back(*left);
        common.emplace_back(input, set);
        if (left == one.end() || left->first != input) continue;
        common.back().second.intersect(left->second);
        if (common.back().second.isEmpty()) return std::nullopt;
        ++left;
    }
    common.insert(common.end(), left, one.end());
    return common;
}

/// Where a trapezoid has a degree above 0, and where a full one, changes at its corners only. So values need
/// not be sampled: a range falls into cells, corners and what lies between them, on which every term is
/// constant in this respect. A condition over several inputs then holds on a union of boxes, each a set of
/// cells for every input that it asks for.
RuleReach::RuleReach(const FuzzySystem& system) {
    for (const FuzzyVariable& input : system.inputs) {
        m_cells.push_back(cellsOf(input));
        m_terms.emplace_back();
        for (const FuzzyTerm& term : input.terms)
            m_terms.back().push_back({supportOf(term.set, m_cells.back()), coreOf(term.set, m_cells.back())});
    }
}

std::optional<std::vector<ValueBox>> RuleReach::where(const FuzzyCondition& condition, Degree degree) {
    m_isTooMuch = m_work > mostBoxWork;
    Boxes boxes;
    if (!m_isTooMuch) boxes = boxesOf(condition, {degree, false});
    if (m_isTooMuch) return std::nullopt;
    return boxes;
}

/// a AND b is above 0 where both are and full where both are, a OR b where either is; NOT a is above 0
/// exactly where a is not full, and full where a is 0. So NOT is taken inwards by De Morgan's laws: under it
/// AND and OR change places, and each of the two questions becomes the other. That is exact for minimum,
/// product, maximum and probabilistic sum. Bounded difference makes 0 of two small degrees and bounded sum 1
/// of two large ones, which this does not see.
RuleReach::Boxes RuleReach::boxesOf(const FuzzyCondition& condition, Wanted wanted) {
    using Kind = FuzzyCondition::Kind;
    if (condition.kind == Kind::Is) return propositionBoxes(condition.proposition, wanted);
    if (condition.kind == Kind::Not)
        return boxesOf(condition.parts.front(), {wanted.degree, !wanted.isNegated});
    const bool areAlternatives = (condition.kind == Kind::Or) != wanted.isNegated;
    Boxes boxes = boxesOf(condition.parts.front(), wanted);
    for (auto part = condition.parts.begin() + 1; part != condition.parts.end() && !m_isTooMuch; ++part) {
        const Boxes next = boxesOf(*part, wanted);
        if (!areAlternatives)
            boxes = commonOf(boxes, next);
        else
            for (const ValueBox& box : next)
                include(boxes, box);
    }
    return boxes;
}

/// NOT holds more than nothing where what it denies does not hold fully, and fully where that does not hold
/// at all.
RuleReach::Boxes RuleReach::propositionBoxes(const FuzzyProposition& proposition, Wanted wanted) const {
    const auto [input, term] = proposition;
    const TermCells& cells = m_terms[input][term];
    const bool wantsSupport = (wanted.degree == Degree::AboveZero) != wanted.isNegated;
    CellSet set = wantsSupport ? cells.support : cells.core;
    if (wanted.isNegated) set = complementOf(set, m_cells[input].size());
    if (set.isEmpty()) return {};
    if (set.isWhole()) return {ValueBox{}};
    return {ValueBox{{input, std::move(set)}}};
}

/// Of two conditions that must both hold, each box of one with each of the other: the only step that
/// multiplies boxes, and the one that has to be watched.
RuleReach::Boxes RuleReach::commonOf(const Boxes& one, const Boxes& other) {
    Boxes common;
    for (const ValueBox& a : one)
        for (const ValueBox& b : other) {
            if (m_isTooMuch) return {};
            if (const auto box = commonPart(a, b)) include(common, *box);
        }
    return common;
}

/// Boxes that lie in others, or make one with another, are not kept: alternatives of neighbouring terms
/// mostly join to one. Else n AND of two alternatives each would have 2ⁿ boxes; where they still become too
/// many, the search is given up, and it is said that not all was checked.
void RuleReach::include(Boxes& boxes, const ValueBox& box) {
    m_work += boxes.size() + 1;
    for (ValueBox& there : boxes)
        if (isWithin(box, there) || mergeInto(there, box)) return;
    boxes.push_back(box);
    if (boxes.size() > mostBoxes || m_work > mostBoxWork) m_isTooMuch = true;
}

} // namespace esm
