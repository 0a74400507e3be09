#include "core/fuzzy/empty_outputs.h"

#include <algorithm>
#include <map>

namespace esm {

namespace {

using Boxes = std::vector<ValueBox>;

constexpr std::size_t mostCases = 500; // of one output

const CellSet* valuesOf(const ValueBox& box, std::size_t input) {
    const auto found =
        std::find_if(box.begin(), box.end(), [&](const auto& entry) { return entry.first == input; });
    return found == box.end() ? nullptr : &found->second;
}

/// The boxes of values in which a rule that concludes the output fires.
std::optional<Boxes> firingBoxes(const std::vector<RuleFacts>& rules, std::size_t output) {
    Boxes boxes;
    for (const RuleFacts& facts : rules) {
        if (!facts.canFire || facts.concluded.count(output) == 0) continue;
        if (!facts.above) return std::nullopt;
        boxes.insert(boxes.end(), facts.above->begin(), facts.above->end());
    }
    return boxes;
}

/// The cells of an input that lie in no box: there the input decides alone.
CellSet cellsOutside(const Boxes& boxes, std::size_t input, std::size_t cells) {
    CellSet covered(cells);
    for (const ValueBox& box : boxes) {
        const CellSet* values = valuesOf(box, input);
        if (!values) return CellSet(cells);
        covered.unite(*values);
    }
    return complementOf(covered, cells);
}

/// What is left of the inputs' ranges when all boxes are taken out, input by input: cells of an input that
/// lie in the same boxes go on together, with these boxes alone and the inputs behind. Where none is left,
/// all that is behind is empty; where one is left that asks for nothing behind, nothing is. To subtract box
/// by box would leave the same in many small pieces, cut as the order of the rules has it.
class CaseSearch {
public:
    CaseSearch(const Boxes& boxes, const std::vector<CellSet>& decided, const RuleReach& reach,
               std::size_t& work)
        : m_boxes(boxes), m_decided(decided), m_reach(reach), m_work(work) {}

    std::optional<Boxes> all() {
        std::vector<std::size_t> every(m_boxes.size());
        for (std::size_t i = 0; i < every.size(); ++i)
            every[i] = i;
        Boxes found = from(0, every);
        if (m_isTooMuch) return std::nullopt;
        return found;
    }

private:
    using Chosen = std::vector<std::size_t>; // boxes, by index

    Boxes from(std::size_t input, const Chosen& boxes) {
        if (boxes.empty()) return {ValueBox{}};
        const auto goesOn = [&](std::size_t box) { return asksFrom(input, m_boxes[box]); };
        if (m_isTooMuch || !std::all_of(boxes.begin(), boxes.end(), goesOn)) return {};
        // Cells that leave the same behind are told together.
        std::vector<std::pair<Boxes, CellSet>> groups;
        for (const auto& [chosen, cells] : cellsByBoxes(input, boxes)) {
            const Boxes behind = from(input + 1, chosen);
            const auto same = std::find_if(groups.begin(), groups.end(),
                                           [&](const auto& group) { return group.first == behind; });
            if (same != groups.end())
                same->second.unite(cells);
            else
                groups.emplace_back(behind, cells);
        }
        return joinedWith(input, groups);
    }

    static bool asksFrom(std::size_t input, const ValueBox& box) {
        return !box.empty() && box.back().first >= input;
    }

    std::map<Chosen, CellSet> cellsByBoxes(std::size_t input, const Chosen& boxes) {
        const std::size_t cells = m_reach.cells(input).size();
        m_work += cells * boxes.size();
        m_isTooMuch = m_isTooMuch || m_work > mostCaseWork;
        std::map<Chosen, CellSet> groups;
        for (std::size_t cell = 0; cell < cells && !m_isTooMuch; ++cell) {
            if (m_decided[input].contains(cell)) continue;
            Chosen there;
            for (const std::size_t box : boxes)
                if (const CellSet* values = valuesOf(m_boxes[box], input); !values || values->contains(cell))
                    there.push_back(box);
            groups.try_emplace(std::move(there), CellSet(cells)).first->second.add(cell);
        }
        return groups;
    }

    Boxes joinedWith(std::size_t input, const std::vector<std::pair<Boxes, CellSet>>& groups) {
        Boxes found;
        for (const auto& [behind, cells] : groups)
            for (const ValueBox& box : behind) {
                found.push_back(box);
                CellSet besides = m_decided[input];
                besides.unite(cells);
                if (!besides.isWhole()) found.back().emplace(found.back().begin(), input, cells);
            }
        m_isTooMuch = m_isTooMuch || found.size() > mostCases;
        return found;
    }

    const Boxes& m_boxes;
    const std::vector<CellSet>& m_decided;
    const RuleReach& m_reach;
    std::size_t& m_work;
    bool m_isTooMuch = false;
};

/// The part of all combinations of values that a box holds, 0 to 1.
double shareOf(const ValueBox& box, const RuleReach& reach) {
    double share = 1;
    for (const auto& [input, set] : box) {
        const std::vector<ValueCell>& cells = reach.cells(input);
        double width = 0; // halved, as the difference of two large numbers may be none
        for (const ValueRange& range : rangesOf(cells, set))
            width += range.to / 2 - range.from / 2;
        share *= width / (cells.back().to / 2 - cells.front().from / 2);
    }
    return share;
}

void sortByShare(Boxes& boxes, const RuleReach& reach) {
    std::stable_sort(boxes.begin(), boxes.end(), [&](const ValueBox& a, const ValueBox& b) {
        return shareOf(a, reach) > shareOf(b, reach);
    });
}

} // namespace

std::optional<EmptyCases> emptyCases(const std::vector<RuleFacts>& rules, std::size_t output,
                                     const RuleReach& reach, std::size_t& work) {
    const std::optional<Boxes> firing = firingBoxes(rules, output);
    if (!firing) return std::nullopt;
    EmptyCases cases;
    for (std::size_t input = 0; input < reach.inputs(); ++input) {
        const std::size_t cells = reach.cells(input).size();
        // What no rule ever fires for is told as such, and not of each input.
        cases.decided.push_back(firing->empty() ? CellSet(cells) : cellsOutside(*firing, input, cells));
    }
    std::optional<Boxes> combined = CaseSearch(*firing, cases.decided, reach, work).all();
    if (!combined) return std::nullopt;
    cases.combined = std::move(*combined);
    sortByShare(cases.combined, reach);
    return cases;
}

} // namespace esm
