#include "core/model/detail.h"

namespace esm {

// The level is read off the network and not stored beside it, so that the two cannot disagree. A binding with
// triangles is a coarser surface; one without is the line of the stiff piece.
Detail detailOf(const SpringNetwork& network) {
    const std::size_t nodes = network.restPositions.size();
    if (network.lattice) return {Detail::Kind::Filled, nodes, network.lattice->filling};
    const bool isEven = network.sheet.has_value();
    if (!network.binding) return {Detail::Kind::EveryVertex, nodes, {}, isEven};
    return {isOnOneLine(*network.binding) ? Detail::Kind::Rigid : Detail::Kind::Nodes, nodes, {}, isEven};
}

} // namespace esm
