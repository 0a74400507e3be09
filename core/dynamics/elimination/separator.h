#pragma once

#include "core/dynamics/elimination/row_graph.h"

#include <vector>

namespace esm {

enum class Side : char { Neither, First, Second };

/// Looks for the fewest rows between two sides of a graph.
class SeparatorSearch {
public:
    explicit SeparatorSearch(const RowGraph& graph)
        : m_graph(graph), m_partners(graph.rowCount(), -1), m_rounds(graph.rowCount(), 0) {}

    /// Rows without which no row of the first side is coupled to one of the second; of each such coupling one
    /// end at least.
    /// @param first the rows of the first side
    /// @param sides per row
    std::vector<int> between(const std::vector<int>& first, const std::vector<Side>& sides);

private:
    bool isNew(int row);
    void pairGreedily(const std::vector<int>& border, const std::vector<Side>& sides);
    bool pair(int row, const std::vector<Side>& sides);
    void reach(int row, const std::vector<Side>& sides);
    int& partnerOf(int row) { return m_partners[static_cast<std::size_t>(row)]; }

    const RowGraph& m_graph;
    std::vector<int> m_partners; ///< per row, on the other side; −1: none
    std::vector<int> m_rounds;   ///< per row, in which it was met last
    int m_round = 0;
};

} // namespace esm
