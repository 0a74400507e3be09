#pragma once

#include "core/dynamics/spring_system.h"

#include <cstdint>
#include <span>
#include <vector>

namespace esm {

/// What holds each node: its springs and hinges, in their order, and its tethers as one.
class NodeTies {
public:
    /// A spring's other end, and the spring.
    struct Neighbour {
        std::uint32_t node, spring;
    };

    /// A hinge, and which of its four nodes it is.
    struct Corner {
        std::uint32_t hinge, place;
    };

    explicit NodeTies(const SpringSystem& system);

    std::size_t nodeCount() const { return m_tethers.size(); }
    std::span<const Neighbour> springsOf(std::uint32_t node) const {
        return {m_neighbours.data() + m_starts[node], m_starts[node + 1] - m_starts[node]};
    }
    const std::vector<Corner>& hingesOf(std::uint32_t node) const { return m_corners[node]; }
    /// Of constant 0 where there is none.
    const Tether& tetherOf(std::uint32_t node) const { return m_tethers[node]; }

private:
    std::vector<std::size_t> m_starts; ///< per node and one more: where its neighbours begin
    std::vector<Neighbour> m_neighbours;
    std::vector<std::vector<Corner>> m_corners; ///< per node
    std::vector<Tether> m_tethers;              ///< per node
};

} // namespace esm
