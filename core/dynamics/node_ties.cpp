#include "core/dynamics/node_ties.h"

namespace esm {

// How many springs each node has tells where its list begins.
NodeTies::NodeTies(const SpringSystem& system)
    : m_starts(system.mass.size() + 1, 0), m_neighbours(2 * system.springs.size()),
      m_corners(system.mass.size()) {
    for (const auto& spring : system.springs)
        for (const std::uint32_t node : {spring.first, spring.second})
            ++m_starts[node + 1];
    for (std::size_t node = 1; node < m_starts.size(); ++node)
        m_starts[node] += m_starts[node - 1];
    std::vector<std::size_t> next(m_starts.begin(), m_starts.end() - 1);
    for (std::uint32_t i = 0; i < system.springs.size(); ++i) {
        const std::uint32_t first = system.springs[i].first, second = system.springs[i].second;
        m_neighbours[next[first]++] = {second, i};
        m_neighbours[next[second]++] = {first, i};
    }
    for (std::uint32_t i = 0; i < system.hinges.size(); ++i)
        for (std::uint32_t place = 0; place < 4; ++place)
            m_corners[system.hinges[i].nodes[place]].push_back({i, place});
    for (std::uint32_t node = 0; node < system.mass.size(); ++node)
        m_tethers.push_back({node, 0, 0});
    for (const Tether& tether : system.tethers) {
        m_tethers[tether.node].springConstant += tether.springConstant;
        m_tethers[tether.node].viscosity += tether.viscosity;
    }
}

} // namespace esm
