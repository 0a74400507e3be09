#include "core/model/detail.h"

namespace esm {

Detail detailOf(const SpringNetwork& network) {
    const std::size_t nodes = network.restPositions.size();
    if (!network.binding) return {Detail::Kind::EveryVertex, nodes};
    return {network.binding->surface.empty() ? Detail::Kind::Rigid : Detail::Kind::Nodes, nodes};
}

} // namespace esm
