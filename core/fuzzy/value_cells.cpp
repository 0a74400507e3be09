#include "core/fuzzy/value_cells.h"

#include "core/support/numbers.h"

#include <algorithm>
#include <cmath>

namespace esm {

namespace {

/// A value of the cell, exact enough to be compared with corners. Halved before they are added, as two large
/// numbers may not be addable.
double valueWithin(const ValueCell& cell) {
    return cell.from == cell.to ? cell.from : cell.from / 2 + cell.to / 2;
}

/// Not by the degree, which rounding may take for 0 or 1 close to a corner.
bool belongsTo(const Trapezoid& set, double x) {
    const bool isRight = x > set.a || (x == set.a && set.a == set.b);
    return isRight && (x < set.d || (x == set.d && set.c == set.d));
}

template<class Holds> CellSet cellsWhere(const std::vector<ValueCell>& cells, const Holds& holds) {
    CellSet set(cells.size());
    for (std::size_t i = 0; i < cells.size(); ++i)
        if (holds(valueWithin(cells[i]))) set.add(i);
    return set;
}

} // namespace

std::string inWords(const ValueRange& range, const std::string& unit) {
    const std::string from = roundedText(range.from);
    const std::string to = roundedText(range.to) + (unit.empty() ? "" : " " + unit);
    if (range.from == range.to) return "exactly " + to;
    if (range.includesFrom) return "from " + from + (range.includesTo ? " to " : " to below ") + to;
    return range.includesTo ? "above " + from + ", up to " + to : "between " + from + " and " + to;
}

/// Whether a degree is above 0, and whether it is 1, changes at corners only. Each corner and each stretch
/// between two of them is therefore one cell, and a statement on a range is one on some dozen cells. That is
/// exact, where sampling would miss what lies between two samples. Corners are cells of their own: there a
/// term may hold fully that does not do so on either side, as a single point does.
std::vector<ValueCell> cellsOf(const FuzzyVariable& variable) {
    std::vector<double> corners{variable.minimum, variable.maximum};
    for (const FuzzyTerm& term : variable.terms)
        for (const double corner : {term.set.a, term.set.b, term.set.c, term.set.d})
            if (corner > variable.minimum && corner < variable.maximum) corners.push_back(corner);
    std::sort(corners.begin(), corners.end());
    corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
    std::vector<ValueCell> cells;
    for (const double corner : corners) {
        // No number lies between two that follow each other.
        const bool isApart = !cells.empty() && std::nextafter(cells.back().to, corner) < corner;
        if (isApart) cells.push_back({cells.back().to, corner});
        cells.push_back({corner, corner});
    }
    return cells;
}

bool CellSet::isEmpty() const {
    return std::all_of(m_words.begin(), m_words.end(), [](std::uint64_t word) { return word == 0; });
}

/// Cell by cell, since the last word has bits that stand for none. The others compare 64 cells at once.
bool CellSet::isWhole() const {
    for (std::size_t i = 0; i < m_cells; ++i)
        if (!contains(i)) return false;
    return true;
}

bool CellSet::isWithin(const CellSet& other) const {
    return std::equal(m_words.begin(), m_words.end(), other.m_words.begin(),
                      [](std::uint64_t mine, std::uint64_t theirs) { return (mine & ~theirs) == 0; });
}

bool CellSet::meets(const CellSet& other) const {
    for (std::size_t i = 0; i < m_words.size(); ++i)
        if ((m_words[i] & other.m_words[i]) != 0) return true;
    return false;
}

void CellSet::unite(const CellSet& other) {
    for (std::size_t i = 0; i < m_words.size(); ++i)
        m_words[i] |= other.m_words[i];
}

void CellSet::intersect(const CellSet& other) {
    for (std::size_t i = 0; i < m_words.size(); ++i)
        m_words[i] &= other.m_words[i];
}

/// Neighbouring cells become one range; it includes an end where the cell there is a corner.
std::vector<ValueRange> rangesOf(const std::vector<ValueCell>& cells, const CellSet& set) {
    std::vector<ValueRange> ranges;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        if (!set.contains(i)) continue;
        const bool isCorner = cells[i].from == cells[i].to;
        if (i == 0 || !set.contains(i - 1)) ranges.push_back({cells[i].from, 0, isCorner, false});
        ranges.back().to = cells[i].to;
        ranges.back().includesTo = isCorner;
    }
    return ranges;
}

CellSet supportOf(const Trapezoid& set, const std::vector<ValueCell>& cells) {
    return cellsWhere(cells, [&](double x) { return belongsTo(set, x); });
}

CellSet coreOf(const Trapezoid& set, const std::vector<ValueCell>& cells) {
    return cellsWhere(cells, [&](double x) { return x >= set.b && x <= set.c; });
}

CellSet complementOf(const CellSet& set, std::size_t cells) {
    CellSet rest(cells);
    for (std::size_t i = 0; i < cells; ++i)
        if (!set.contains(i)) rest.add(i);
    return rest;
}

std::vector<ValueRange> partitionGaps(const FuzzyVariable& variable) {
    const std::vector<ValueCell> cells = cellsOf(variable);
    CellSet covered(cells.size());
    for (const FuzzyTerm& term : variable.terms)
        covered.unite(supportOf(term.set, cells));
    return rangesOf(cells, complementOf(covered, cells.size()));
}

} // namespace esm
