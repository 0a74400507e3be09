#include "core/model/topology.h"

#include "core/support/offenders.h"

#include <cmath>
#include <numeric>

namespace esm {

Topology authoredTopology(std::shared_ptr<const TriangleMesh> surface,
                          std::shared_ptr<const SpringNetwork> network) {
    std::vector<std::uint32_t> origin(network->restPositions.size());
    std::iota(origin.begin(), origin.end(), 0U);
    return {std::move(surface), std::move(network), std::move(origin)};
}

NodeMap NodeMap::identity(std::size_t nodeCount) {
    NodeMap map;
    for (std::uint32_t node = 0; node < nodeCount; ++node)
        map.add({{node, 1}});
    return map;
}

// Sources of all nodes lie in one list, and of each node only the end is kept, as in a compressed sparse
// matrix. Nearly all nodes come from one: a list for each would be mostly overhead.
void NodeMap::add(const std::vector<Source>& sources) {
    m_sources.insert(m_sources.end(), sources.begin(), sources.end());
    m_ends.push_back(m_sources.size());
}

// Positions and velocities alike, as a cut keeps both. The sum begins with its first term: a node that comes
// from one alone keeps every bit, the sign of a zero too.
std::vector<Eigen::Vector3d> NodeMap::mapped(const std::vector<Eigen::Vector3d>& ofNodesBefore) const {
    std::vector<Eigen::Vector3d> result;
    result.reserve(m_ends.size());
    std::size_t next = 0;
    for (const std::size_t end : m_ends) {
        Eigen::Vector3d sum = m_sources[next].weight * ofNodesBefore[m_sources[next].node];
        for (++next; next < end; ++next)
            sum += m_sources[next].weight * ofNodesBefore[m_sources[next].node];
        result.push_back(sum);
    }
    return result;
}

// Weights that do not add up to 1 would move a node towards the origin. The tolerance is that of rounding:
// weights of some ten nodes, each rounded to 16 digits, are off by far less.
std::vector<std::string> NodeMap::problems(std::size_t before, std::size_t after) const {
    std::vector<std::string> found;
    if (m_ends.size() != after)
        found.push_back("the map of nodes is for " + std::to_string(m_ends.size()) + " of " +
                        std::to_string(after) + " nodes");
    std::vector<std::size_t> offenders;
    std::size_t next = 0;
    for (std::size_t node = 0; node < m_ends.size(); ++node) {
        constexpr double rounding = 1e-9;
        double sum = 0;
        bool exists = true;
        for (; next < m_ends[node]; ++next) {
            exists = exists && m_sources[next].node < before;
            sum += m_sources[next].weight;
        }
        if (!exists || !(std::abs(sum - 1) <= rounding)) offenders.push_back(node);
    }
    reportOffenders(found, "node", "that comes from none there was, or by weights that are not of one",
                    offenders);
    return found;
}

} // namespace esm
