#include "core/dynamics/elimination/separator.h"

#include <algorithm>

namespace esm {

namespace {

Side sideOf(int row, const std::vector<Side>& sides) {
    return sides[static_cast<std::size_t>(row)];
}

} // namespace

/// Whether the row is met for the first time in this round.
bool SeparatorSearch::isNew(int row) {
    int& round = m_rounds[static_cast<std::size_t>(row)];
    const bool result = round != m_round;
    round = m_round;
    return result;
}

/// Finds nearly all pairs that there are, so that few have to be looked for.
void SeparatorSearch::pairGreedily(const std::vector<int>& border, const std::vector<Side>& sides) {
    for (const int row : border)
        for (const int other : m_graph.coupledTo(row))
            if (sideOf(other, sides) == Side::Second && partnerOf(other) < 0) {
                partnerOf(row) = other;
                partnerOf(other) = row;
                break;
            }
}

/// Gives a row of the first side a partner, where those who have one may have to take another.
bool SeparatorSearch::pair(int row, const std::vector<Side>& sides) {
    for (const int other : m_graph.coupledTo(row)) {
        if (sideOf(other, sides) != Side::Second || !isNew(other)) continue;
        if (partnerOf(other) >= 0 && !pair(partnerOf(other), sides)) continue;
        partnerOf(row) = other;
        partnerOf(other) = row;
        return true;
    }
    return false;
}

/// Meets all that a row of the first side reaches by couplings there and partners back.
void SeparatorSearch::reach(int row, const std::vector<Side>& sides) {
    if (!isNew(row)) return;
    for (const int other : m_graph.coupledTo(row))
        if (sideOf(other, sides) == Side::Second && isNew(other) && partnerOf(other) >= 0)
            reach(partnerOf(other), sides);
}

// Couplings across the cut make a graph of two sides, and what is looked for are its fewest rows that have an
// end of each coupling. There are as many as most pairs of coupled rows (Kőnig 1931), which are found one
// after the other by ways that alternate (Kuhn 1955). Of each pair, the row of the second side is taken where
// a row without partner reaches it, else that of the first.
std::vector<int> SeparatorSearch::between(const std::vector<int>& first, const std::vector<Side>& sides) {
    std::vector<int> border;
    for (const int row : first)
        for (const int other : m_graph.coupledTo(row)) {
            if (sideOf(other, sides) != Side::Second) continue;
            if (border.empty() || border.back() != row) border.push_back(row);
            partnerOf(row) = partnerOf(other) = -1;
        }
    pairGreedily(border, sides);
    for (bool found = true; found;) {
        found = false;
        ++m_round;
        for (const int row : border)
            if (partnerOf(row) < 0 && pair(row, sides)) found = true;
    }
    ++m_round;
    for (const int row : border)
        if (partnerOf(row) < 0) reach(row, sides);
    std::vector<int> separator;
    for (const int row : border)
        if (partnerOf(row) >= 0) {
            const bool reached = m_rounds[static_cast<std::size_t>(partnerOf(row))] == m_round;
            separator.push_back(reached ? partnerOf(row) : row);
        }
    std::sort(separator.begin(), separator.end());
    return separator;
}

} // namespace esm
