#include "core/dynamics/kernel/node_order.h"

#include <algorithm>
#include <numeric>

namespace esm {

namespace {

using NodeList = std::vector<std::uint32_t>;

/// The neighbours of each node, one list behind the other.
class NodeGraph {
public:
    explicit NodeGraph(const SpringSystem& system)
        : m_starts(system.mass.size() + 1), m_neighbours(2 * system.springs.size()) {
        for (const auto& spring : system.springs) {
            ++m_starts[spring.first];
            ++m_starts[spring.second];
        }
        std::partial_sum(m_starts.begin(), m_starts.end(), m_starts.begin());
        for (const auto& spring : system.springs) {
            m_neighbours[--m_starts[spring.first]] = spring.second;
            m_neighbours[--m_starts[spring.second]] = spring.first;
        }
    }

    std::size_t size() const { return m_starts.size() - 1; }
    std::size_t degree(std::uint32_t node) const { return m_starts[node + 1] - m_starts[node]; }
    const std::uint32_t* begin(std::uint32_t node) const { return m_neighbours.data() + m_starts[node]; }
    const std::uint32_t* end(std::uint32_t node) const { return m_neighbours.data() + m_starts[node + 1]; }

private:
    std::vector<std::size_t> m_starts;
    NodeList m_neighbours;
};

// Cuthill and McKee (1969), turned round as George (1971) does. A step reads, for each node, those its
// springs join. In this order they are of the same level of the breadth-first search or of the next one, so
// that what one node needs is still in the cache for another, however the mesh has scattered its neighbours.
class CuthillMcKee {
public:
    explicit CuthillMcKee(const SpringSystem& system) : m_graph(system), m_round(m_graph.size(), 0) {
        m_order.reserve(m_graph.size());
        NodeList byDegree(m_graph.size());
        std::iota(byDegree.begin(), byDegree.end(), 0);
        std::stable_sort(byDegree.begin(), byDegree.end(), LowerDegree{m_graph});
        for (const std::uint32_t node : byDegree)
            if (m_round[node] == 0) orderComponent(node);
    }

    NodeList takeOrder() { return std::move(m_order); }

private:
    struct Search {
        std::size_t depth = 0;
        std::uint32_t farthest; ///< of lowest degree among the farthest
    };

    struct LowerDegree {
        const NodeGraph& graph;
        bool operator()(std::uint32_t a, std::uint32_t b) const { return graph.degree(a) < graph.degree(b); }
    };

    /// Appends the component of a node. The search begins anew from the farthest node that it found, as long
    /// as that makes it deeper (George and Liu 1979): the more levels there are the narrower they are, and
    /// narrow levels keep neighbours close. The limit is for graphs that become deeper by a level each time.
    void orderComponent(std::uint32_t start) {
        constexpr int mostSearches = 8;
        const std::size_t ordered = m_order.size();
        Search search = append(start);
        for (int i = 0; i < mostSearches; ++i) {
            m_order.resize(ordered);
            const Search next = append(search.farthest);
            const bool isLast = next.depth <= search.depth;
            search = next;
            if (isLast) return;
        }
    }

    /// Breadth first, the neighbours of each node by their degree.
    Search append(std::uint32_t start) {
        ++m_currentRound;
        std::size_t levelBegin = m_order.size(), levelEnd = levelBegin + 1;
        take(start);
        Search search;
        for (std::size_t next = levelBegin; next < m_order.size(); ++next) {
            if (next == levelEnd) {
                ++search.depth;
                levelBegin = std::exchange(levelEnd, m_order.size());
            }
            const auto newOnes = static_cast<std::ptrdiff_t>(m_order.size());
            for (const std::uint32_t neighbour : NeighboursOf{m_graph, m_order[next]})
                if (m_round[neighbour] != m_currentRound) take(neighbour);
            std::sort(m_order.begin() + newOnes, m_order.end(), [this](std::uint32_t a, std::uint32_t b) {
                return std::pair(m_graph.degree(a), a) < std::pair(m_graph.degree(b), b);
            });
        }
        search.farthest = *std::min_element(m_order.begin() + static_cast<std::ptrdiff_t>(levelBegin),
                                            m_order.end(), LowerDegree{m_graph});
        return search;
    }

    struct NeighboursOf {
        const NodeGraph& graph;
        std::uint32_t node;
        const std::uint32_t* begin() const { return graph.begin(node); }
        const std::uint32_t* end() const { return graph.end(node); }
    };

    void take(std::uint32_t node) {
        m_round[node] = m_currentRound;
        m_order.push_back(node);
    }

    NodeGraph m_graph;
    std::vector<std::uint32_t> m_round; ///< in which search a node was last reached; 0 is none
    std::uint32_t m_currentRound = 0;
    NodeList m_order;
};

} // namespace

std::vector<std::uint32_t> reverseCuthillMcKee(const SpringSystem& system) {
    std::vector<std::uint32_t> order = CuthillMcKee(system).takeOrder();
    std::reverse(order.begin(), order.end());
    return order;
}

} // namespace esm
