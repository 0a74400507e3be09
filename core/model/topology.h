#pragma once

#include "core/model/spring_network.h"

#include <memory>
#include <string>

namespace esm {

/// What an organ is made of while it lives: the surface that is drawn, and the nodes and springs beneath,
/// whose network says how they carry it. Immutable; an operation makes another one.
struct Topology {
    std::shared_ptr<const TriangleMesh> surface;
    std::shared_ptr<const SpringNetwork> network;
    /// Per node, the authored one that it came from. The surface's triangles keep their places.
    std::vector<std::uint32_t> origin;
};

/// What was authored: every node comes from itself.
Topology authoredTopology(std::shared_ptr<const TriangleMesh> surface,
                          std::shared_ptr<const SpringNetwork> network);

/// For each node of a new network, which nodes of the one before it comes from.
class NodeMap {
public:
    struct Source {
        std::uint32_t node; ///< of the network before
        double weight;      ///< the node's sum to 1
    };

    /// Every node comes from the one of its number.
    static NodeMap identity(std::size_t nodeCount);

    std::size_t size() const { return m_ends.size(); } ///< nodes of the new network
    /// The next node comes from these. Precondition: at least one.
    void add(const std::vector<Source>& sources);

    /// Of every new node, what its sources have, by their weights.
    std::vector<Eigen::Vector3d> mapped(const std::vector<Eigen::Vector3d>& ofNodesBefore) const;

    /// Every problem of a map from so many nodes to so many. Empty when it is one.
    std::vector<std::string> problems(std::size_t before, std::size_t after) const;

private:
    std::vector<Source> m_sources;   ///< one node's after the other's
    std::vector<std::size_t> m_ends; ///< where those of each node end
};

} // namespace esm
