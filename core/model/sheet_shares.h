#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace esm {

/// How the tissue of a surface is shared out over its springs and nodes, so that it is one even sheet however
/// it is meshed (docs/net-elasticity.md). A surface without them gives every spring its tissue's constant and
/// every node as much mass as any other, as the source does [R 2.3.7].
struct SheetShares {
    std::vector<double> springs; ///< of each spring its constant, and viscosity, over those of its tissue
    std::vector<double> nodes;   ///< of each node the surface it stands for, over the mean of all nodes
};

/// Every problem of shares for so many springs and nodes. Empty when tissue can be shared out by them.
std::vector<std::string> validate(const SheetShares& shares, std::size_t springCount, std::size_t nodeCount);

} // namespace esm
