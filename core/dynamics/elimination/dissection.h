#pragma once

#include "core/dynamics/elimination/row_graph.h"

#include <Eigen/Core>

#include <vector>

namespace esm {

/// An order with little fill-in for matrices whose couplings are short in space. Depends on the arguments
/// alone. Whatever the places are, the order can be used; it is good where most couplings are short.
/// @param places of the rows, m
std::vector<int> dissect(const RowGraph& graph, const std::vector<Eigen::Vector3d>& places);

} // namespace esm
