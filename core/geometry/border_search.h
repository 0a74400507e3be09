#pragma once

#include "core/geometry/border_loops.h"

#include <optional>

namespace esm {

/// The corners of all loops in one row, loop after loop. Each begins the border's edge to the next.
struct BorderCorners {
    std::vector<std::uint32_t> vertex;
    std::vector<std::uint32_t> loop;
    std::vector<std::uint32_t> next, previous; ///< corners

    explicit BorderCorners(const std::vector<BorderLoop>& loops);
    std::size_t size() const { return vertex.size(); }
};

/// Finds what lies across a gap. Vertices and corners outlive it.
class BorderSearch {
public:
    BorderSearch(const std::vector<Eigen::Vector3d>& vertices, const BorderCorners& corners);

    struct Opposite {
        std::uint32_t corner; ///< of the edge
        double along;         ///< 0 to 1, on it
        double distance;      ///< unit of the vertices
    };
    /// The nearest place of a border that runs the other way, within reach. None of the corner's own edges.
    std::optional<Opposite> oppositeOf(std::uint32_t corner, double reach) const;

private:
    static constexpr std::size_t leafSize = 4;
    struct Node {
        Eigen::AlignedBox3d box;
        std::uint32_t first, last;       ///< of the order
        std::uint32_t low = 0, high = 0; ///< nodes; 0 in a leaf
    };

    std::uint32_t build(std::uint32_t first, std::uint32_t last);
    bool isOpposite(std::uint32_t corner, std::uint32_t edge) const;
    void look(std::uint32_t node, std::uint32_t corner, std::optional<Opposite>& best, double& reach) const;
    void compare(std::uint32_t edge, std::uint32_t corner, std::optional<Opposite>& best,
                 double& reach) const;
    const Eigen::Vector3d& at(std::uint32_t corner) const { return m_vertices[m_corners.vertex[corner]]; }

    const std::vector<Eigen::Vector3d>& m_vertices;
    const BorderCorners& m_corners;
    std::vector<Eigen::Vector3d> m_directions; ///< of the border at each corner, length 1 or 0
    std::vector<std::uint32_t> m_order;        ///< edges, by their first corners
    std::vector<Node> m_nodes;
};

} // namespace esm
