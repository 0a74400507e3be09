#pragma once

#include "core/dynamics/elimination/row_graph.h"

#include <limits>
#include <optional>
#include <vector>

namespace esm {

/// What a matrix's factor looks like when its rows are eliminated in an order. Each row's parent is the first
/// one that its elimination changes; rows follow each other in such an order that those below a row in the
/// tree come right before it. All by place in that order.
struct EliminationTree {
    std::vector<int> order;   ///< row of the matrix
    std::vector<int> parents; ///< −1: none
    std::vector<int> counts;  ///< entries in the factor's column, its diagonal with them
};

/// @param order in which to eliminate the rows; changed only where that changes nothing in the factor
/// @param mostEntries of the factor; none where it has more
std::optional<EliminationTree>
eliminationTree(const RowGraph& graph, const std::vector<int>& order,
                std::size_t mostEntries = std::numeric_limits<std::size_t>::max());

} // namespace esm
