#pragma once

#include "core/dynamics/elimination/row_graph.h"

#include <Eigen/Core>

#include <vector>

namespace esm {

/// In which order to eliminate the rows of a matrix. The order consists of pieces of a few rows, each of
/// which is coupled, before or after elimination, to pieces that come later on one way through them.
struct Dissection {
    std::vector<int> order;     ///< rows of the matrix
    std::vector<int> pieceEnds; ///< where in the order each piece ends
};

/// An order with little fill-in for matrices whose couplings are short in space. Depends on the arguments
/// alone. Whatever the places are, the order can be used; it is good where most couplings are short.
/// @param places of the rows, m
Dissection dissect(const RowGraph& graph, const std::vector<Eigen::Vector3d>& places);

} // namespace esm
