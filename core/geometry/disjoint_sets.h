#pragma once

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

namespace esm {

/// Numbers joined into sets, each set named by its lowest number: a forest in which every number points
/// towards the lowest of its set. Looking one up halves the way for the next time (path halving, Tarjan and
/// van Leeuwen 1984). The lower root always stays root, so that names do not depend on the order of joining;
/// that costs at most a logarithm.
class DisjointSets {
public:
    explicit DisjointSets(std::size_t count) : m_parents(count) {
        std::iota(m_parents.begin(), m_parents.end(), 0U);
    }

    /// The lowest number of the set.
    std::uint32_t lowest(std::uint32_t number) {
        while (m_parents[number] != number)
            number = m_parents[number] = m_parents[m_parents[number]];
        return number;
    }

    void join(std::uint32_t one, std::uint32_t other) {
        const auto [low, high] = std::minmax({lowest(one), lowest(other)});
        m_parents[high] = low;
    }

private:
    std::vector<std::uint32_t> m_parents;
};

} // namespace esm
