#include "core/solid/prism_springs.h"

#include "core/model/net_elasticity.h"

#include <algorithm>
#include <cmath>

namespace esm {

namespace {

using Eigen::Vector3d;

/// Where what resists stretching lies: in each level of nodes and in all diagonals together, over the whole.
struct WallShares {
    double outer, inner, diagonals;
};

// The levels of a wall lie at z from its middle. What counts of each share sums up to 1 in stretching, as of
// a sheet, and times 12·z²/t² in bending, as of a plate: for two layers that would be Simpson's rule, 1/6,
// 4/6 and 1/6, without diagonals. One layer has no level in its middle and bends nearly three times as
// stiffly as it should. Levels count whole. Diagonals give way the more the fewer mirrored neighbours keep
// the levels from sliding: how much of them counts was measured (docs/prism-walls.md).
WallShares wallSharesOf(int layers) {
    constexpr double diagonals = 0.25;
    constexpr double countingInStretchOfOne = 0.25, countingInBendOfTwo = 0.28, countingInBend = 0.9;
    if (layers == 1) return {(1 - countingInStretchOfOne * diagonals) / 2, 0, diagonals};
    const double counting = layers == 2 ? countingInBendOfTwo : countingInBend, count = layers;
    const double outer = (1 - counting * diagonals - (1 - diagonals) * (count - 2) / count) / (4 + 4 / count);
    return {outer, (1 - diagonals - 2 * outer) / (count - 1), diagonals};
}

/// One side of a layer as a net of its own.
struct WallLevel {
    std::vector<Vector3d> nodes;
    std::vector<double> factors; ///< per edge, `netFactors()`
    std::vector<double> areas;   ///< per node, m²
};

class PrismSprings {
public:
    PrismSprings(const std::vector<Vector3d>& nodes, const std::vector<Triangle>& triangles,
                 const std::vector<std::uint32_t>& order, const LatticeFilling& filling)
        : m_order(order), m_filling(filling), m_count(static_cast<std::uint32_t>(order.size())),
          m_edges(uniqueEdges(triangles)), m_nodes(nodes), m_triangles(triangles),
          m_shares(wallSharesOf(filling.layers)) {}

    std::vector<LatticeSpring> all(const Progress& progress) {
        ProgressParts parts(progress);
        const int levels = m_filling.layers + 1;
        for (int level = 0; level < levels; ++level)
            m_levels.push_back(levelOf(level, parts.next(0.95 / levels)));
        for (int level = 0; level < levels; ++level)
            addFaces(level);
        for (int layer = 0; layer < m_filling.layers; ++layer)
            addLayer(layer);
        std::sort(m_springs.begin(), m_springs.end(), [](const auto& one, const auto& other) {
            return std::pair(one.first, one.second) < std::pair(other.first, other.second);
        });
        reportProgress(parts.rest(), 1);
        return std::move(m_springs);
    }

private:
    WallLevel levelOf(int level, const Progress& progress) const {
        const auto first = m_nodes.begin() + static_cast<std::ptrdiff_t>(m_count) * level;
        WallLevel result{{first, first + m_count}, {}, {}};
        std::vector<Spring> springs;
        for (const auto& [one, other] : m_edges)
            springs.push_back({one, other, (result.nodes[one] - result.nodes[other]).norm()});
        result.factors = netFactors(result.nodes, springs, m_triangles, progress);
        result.areas = nodeAreas(result.nodes, m_triangles);
        return result;
    }

    /// How thick a layer is at a vertex, m.
    double heightAt(std::uint32_t vertex) const {
        return (m_nodes[vertex] - m_nodes[vertex + m_count]).norm();
    }
    double heightAt(const Edge& edge) const { return (heightAt(edge.first) + heightAt(edge.second)) / 2; }

    /// How thick the wall is there, over what was asked for.
    double partAt(const Edge& edge) const {
        return heightAt(edge) * m_filling.layers / m_filling.wallThickness;
    }

    void add(std::uint32_t one, std::uint32_t other, double constant) {
        const auto [first, second] = std::minmax(one, other);
        m_springs.push_back({first, second, std::clamp(constant, leastShare, mostShare)});
    }

    // A level between two layers is the side of both, and its springs stand for what each of them has there.
    void addFaces(int level) {
        const bool isInner = level > 0 && level < m_filling.layers;
        const std::uint32_t first = m_count * static_cast<std::uint32_t>(level);
        const WallLevel& net = m_levels[static_cast<std::size_t>(level)];
        for (std::size_t i = 0; i < m_edges.size(); ++i) {
            const auto& [one, other] = m_edges[i];
            add(one + first, other + first,
                (isInner ? m_shares.inner : m_shares.outer) * net.factors[i] * partAt(m_edges[i]));
        }
    }

    // A diagonal that makes the angle θ with its edge lengthens by cosθ times what the edge does; its
    // constant is larger by 1/cos²θ, so that it resists as the edge would.
    void addLayer(int layer) {
        const std::uint32_t above = m_count * static_cast<std::uint32_t>(layer), below = above + m_count;
        const WallLevel &upper = m_levels[static_cast<std::size_t>(layer)],
                        &lower = m_levels[static_cast<std::size_t>(layer) + 1];
        for (std::size_t i = 0; i < m_edges.size(); ++i) {
            auto [one, other] = m_edges[i];
            if ((m_order[one] < m_order[other]) == (layer % 2 == 1)) std::swap(one, other);
            const double along = ((upper.nodes[one] - upper.nodes[other]).norm() +
                                  (lower.nodes[one] - lower.nodes[other]).norm()) /
                                 2;
            const double length = (m_nodes[one + above] - m_nodes[other + below]).norm();
            const double longer = std::min(length * length / (along * along), steepest);
            const double factor = (upper.factors[i] + lower.factors[i]) / 2;
            add(one + above, other + below,
                m_shares.diagonals / m_filling.layers * longer * factor * partAt(m_edges[i]));
        }
        for (std::uint32_t vertex = 0; vertex < m_count; ++vertex)
            add(vertex + above, vertex + below,
                acrossShare((upper.areas[vertex] + lower.areas[vertex]) / 2, heightAt(vertex)));
    }

    /// @param area of the node, m²; @param height of the layer, m
    double acrossShare(double area, double height) const {
        const double steepness = height * height / (2 / std::sqrt(3.0) * area);
        const double whole = std::min(acrossModulus, 4 * steepness);
        const double own = std::max(whole - 3 * m_shares.diagonals * steepness * steepness, 0.2 * whole);
        return own * area / (height * std::sqrt(3.0) / 2 * m_filling.wallThickness);
    }

    static constexpr double steepest = 4;        ///< more of a diagonal would hardly lie along the surface
    static constexpr double acrossModulus = 1.2; ///< over Young's
    static constexpr double leastShare = 1e-6, mostShare = 1000; ///< what `validate(Lattice)` takes

    const std::vector<std::uint32_t>& m_order;
    const LatticeFilling& m_filling;
    const std::uint32_t m_count;
    const std::vector<Edge> m_edges;
    const std::vector<Vector3d>& m_nodes;
    const std::vector<Triangle>& m_triangles;
    const WallShares m_shares;
    std::vector<WallLevel> m_levels;
    std::vector<LatticeSpring> m_springs;
};

} // namespace

// Around each vertex the edges of a level share the sheet out as `netFactors()` says, and diagonals do so the
// more the longer each is than its edge. Springs across take what a solid of ν = 1/4 has in compression
// across, 1.2·E, less what the diagonals resist of it; of a wall thinner than its triangles are wide no more
// than keeps the steps of a simulation as long as those of the surface.
std::vector<LatticeSpring> prismSprings(const std::vector<Vector3d>& nodes,
                                        const std::vector<Triangle>& triangles,
                                        const std::vector<std::uint32_t>& order,
                                        const LatticeFilling& filling, const Progress& progress) {
    return PrismSprings(nodes, triangles, order, filling).all(progress);
}

} // namespace esm
