#include "core/solid/rigid_core.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <array>
#include <optional>

namespace esm {

namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

using CoreNodes = std::vector<std::uint32_t>;

/// Of the sum of d·dᵀ over the springs' directions d, its least eigenvalue: with it a node hangs on a core
/// firmly. Of three springs at right angles it is 1, of neighbours in a lattice a third.
constexpr double firmHold = 0.05;

class CoreSearch {
public:
    CoreSearch(const std::vector<Vector3d>& nodes, const std::vector<LatticeSpring>& springs)
        : m_nodes(nodes), m_neighbours(nodes.size()), m_holds(nodes.size(), Matrix3d::Zero()),
          m_isMember(nodes.size(), 0), m_wasMember(nodes.size(), 0) {
        for (const LatticeSpring& spring : springs) {
            m_neighbours[spring.first].push_back(spring.second);
            m_neighbours[spring.second].push_back(spring.first);
        }
        for (CoreNodes& neighbours : m_neighbours)
            std::sort(neighbours.begin(), neighbours.end());
    }

    CoreNodes largestOf(const CoreNodes& body);

private:
    Vector3d direction(std::uint32_t from, std::uint32_t to) const {
        return (m_nodes[to] - m_nodes[from]).normalized();
    }
    bool areJoined(std::uint32_t one, std::uint32_t other) const {
        return std::binary_search(m_neighbours[one].begin(), m_neighbours[one].end(), other);
    }
    std::optional<std::array<std::uint32_t, 3>> triangleAt(std::uint32_t node) const;
    CoreNodes grownFrom(const std::array<std::uint32_t, 3>& triangle);
    void holdNeighbours(std::uint32_t member, CoreNodes& members);

    const std::vector<Vector3d>& m_nodes;
    std::vector<CoreNodes> m_neighbours; ///< per node, increasing
    std::vector<Matrix3d> m_holds;       ///< per node, sum of d·dᵀ of its springs to members
    CoreNodes m_held;                    ///< whose hold is not zero
    std::vector<char> m_isMember;        ///< per node, of the core that grows
    std::vector<char> m_wasMember;       ///< per node, of one that was grown
};

/// Three nodes that springs join and that lie on no line.
std::optional<std::array<std::uint32_t, 3>> CoreSearch::triangleAt(std::uint32_t node) const {
    const CoreNodes& around = m_neighbours[node];
    for (std::size_t i = 0; i < around.size(); ++i)
        for (std::size_t j = i + 1; j < around.size(); ++j)
            if (direction(node, around[i]).cross(direction(node, around[j])).squaredNorm() > firmHold &&
                areJoined(around[i], around[j]))
                return std::array{node, around[i], around[j]};
    return std::nullopt;
}

/// A new member's springs hold its neighbours; those that are held firmly by now become members.
void CoreSearch::holdNeighbours(std::uint32_t member, CoreNodes& members) {
    for (const std::uint32_t other : m_neighbours[member]) {
        if (m_isMember[other]) continue;
        const Vector3d along = direction(member, other);
        m_holds[other] += along * along.transpose();
        m_held.push_back(other);
        if (m_holds[other].trace() < 2.5) continue; // fewer than three springs
        Eigen::SelfAdjointEigenSolver<Matrix3d> solver;
        solver.computeDirect(m_holds[other], Eigen::EigenvaluesOnly);
        if (solver.eigenvalues()[0] < firmHold) continue;
        m_isMember[other] = 1;
        members.push_back(other);
    }
}

CoreNodes CoreSearch::grownFrom(const std::array<std::uint32_t, 3>& triangle) {
    CoreNodes members(triangle.begin(), triangle.end());
    for (const std::uint32_t node : members)
        m_isMember[node] = 1;
    for (std::size_t i = 0; i < members.size(); ++i)
        holdNeighbours(members[i], members);
    for (const std::uint32_t node : m_held)
        m_holds[node].setZero();
    m_held.clear();
    for (const std::uint32_t node : members) {
        m_isMember[node] = 0;
        m_wasMember[node] = 1;
    }
    return members;
}

CoreNodes CoreSearch::largestOf(const CoreNodes& body) {
    CoreNodes largest;
    for (const std::uint32_t node : body) {
        if (m_wasMember[node]) continue;
        const auto triangle = triangleAt(node);
        if (!triangle) continue;
        CoreNodes core = grownFrom(*triangle);
        if (core.size() > largest.size()) largest = std::move(core);
        if (2 * largest.size() > body.size()) break;
    }
    return largest;
}

} // namespace

// A triangle of springs is rigid. A node that three springs hold to something rigid, not in one plane, can no
// longer move against it, and belongs to it from then on. What grows so out of a triangle takes in a whole
// lattice with second neighbours, in time in proportion to its springs; but for a diamond lattice without a
// surface, which is rigid in a way that no single node shows.
std::vector<char> rigidCores(const std::vector<Vector3d>& nodes, const std::vector<LatticeSpring>& springs,
                             const std::vector<std::vector<std::uint32_t>>& bodies) {
    CoreSearch search(nodes, springs);
    std::vector<char> isRigid(nodes.size(), 0);
    for (const CoreNodes& body : bodies)
        for (const std::uint32_t node : search.largestOf(body))
            isRigid[node] = 1;
    return isRigid;
}

} // namespace esm
