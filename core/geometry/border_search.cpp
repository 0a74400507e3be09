#include "core/geometry/border_search.h"

#include <algorithm>
#include <numeric>

namespace esm {

namespace {

/// Cosine of the angle from which on two borders run against each other. Zigzags of cut meshes turn by up to
/// 60° from edge to edge; the corners of one side and those of the other stay on their own side of it.
constexpr double opposed = -0.25;

} // namespace

BorderCorners::BorderCorners(const std::vector<BorderLoop>& loops) {
    for (std::uint32_t number = 0; number < loops.size(); ++number) {
        const auto first = static_cast<std::uint32_t>(vertex.size());
        const auto count = static_cast<std::uint32_t>(loops[number].size());
        for (std::uint32_t i = 0; i < count; ++i) {
            vertex.push_back(loops[number][i]);
            loop.push_back(number);
            next.push_back(first + (i + 1) % count);
            previous.push_back(first + (i + count - 1) % count);
        }
    }
}

// The two sides of a gap run in opposite directions, since triangles agree which way is outside. That tells
// what lies across a gap from what lies along the same side, whatever the distance asked for is beside the
// edges' lengths. Edges stand in a tree of boxes, so that a search costs a logarithm with any reach.
BorderSearch::BorderSearch(const std::vector<Eigen::Vector3d>& vertices, const BorderCorners& corners)
    : m_vertices(vertices), m_corners(corners), m_order(corners.size()) {
    m_directions.reserve(corners.size());
    for (std::uint32_t i = 0; i < corners.size(); ++i)
        m_directions.push_back((at(corners.next[i]) - at(corners.previous[i])).stableNormalized());
    std::iota(m_order.begin(), m_order.end(), 0U);
    if (!m_order.empty()) build(0, static_cast<std::uint32_t>(m_order.size()));
}

std::uint32_t BorderSearch::build(std::uint32_t first, std::uint32_t last) {
    const auto number = static_cast<std::uint32_t>(m_nodes.size());
    Node node{{}, first, last};
    for (std::uint32_t i = first; i < last; ++i)
        node.box.extend(at(m_order[i])).extend(at(m_corners.next[m_order[i]]));
    m_nodes.push_back(node);
    if (last - first <= leafSize) return number;
    Eigen::Index axis = 0;
    node.box.sizes().maxCoeff(&axis);
    const auto middle = (first + last) / 2;
    const auto keyOf = [&](std::uint32_t edge) {
        return std::pair(at(edge)[axis] + at(m_corners.next[edge])[axis], edge);
    };
    std::nth_element(m_order.begin() + first, m_order.begin() + middle, m_order.begin() + last,
                     [&](std::uint32_t a, std::uint32_t b) { return keyOf(a) < keyOf(b); });
    const std::uint32_t low = build(first, middle), high = build(middle, last);
    m_nodes[number].low = low;
    m_nodes[number].high = high;
    return number;
}

bool BorderSearch::isOpposite(std::uint32_t corner, std::uint32_t edge) const {
    const std::uint32_t end = m_corners.next[edge];
    const std::uint32_t vertex = m_corners.vertex[corner];
    if (m_corners.vertex[edge] == vertex || m_corners.vertex[end] == vertex) return false;
    const Eigen::Vector3d direction = m_directions[edge] + m_directions[end];
    return m_directions[corner].dot(direction) < opposed * direction.norm();
}

void BorderSearch::compare(std::uint32_t edge, std::uint32_t corner, std::optional<Opposite>& best,
                           double& reach) const {
    if (!isOpposite(corner, edge)) return;
    const Eigen::Vector3d &start = at(edge), along = at(m_corners.next[edge]) - start;
    const double squaredLength = along.squaredNorm();
    const double share =
        squaredLength > 0 ? std::clamp((at(corner) - start).dot(along) / squaredLength, 0.0, 1.0) : 0;
    const double distance = (start + share * along - at(corner)).norm();
    if (distance > reach || (best && distance == best->distance)) return;
    best = {edge, share, distance};
    reach = distance;
}

void BorderSearch::look(std::uint32_t node, std::uint32_t corner, std::optional<Opposite>& best,
                        double& reach) const {
    const Node& here = m_nodes[node];
    if (here.box.exteriorDistance(at(corner)) > reach) return;
    if (here.high == 0) {
        for (std::uint32_t i = here.first; i < here.last; ++i)
            compare(m_order[i], corner, best, reach);
        return;
    }
    const bool lowFirst = m_nodes[here.low].box.squaredExteriorDistance(at(corner)) <=
                          m_nodes[here.high].box.squaredExteriorDistance(at(corner));
    look(lowFirst ? here.low : here.high, corner, best, reach);
    look(lowFirst ? here.high : here.low, corner, best, reach);
}

std::optional<BorderSearch::Opposite> BorderSearch::oppositeOf(std::uint32_t corner, double reach) const {
    std::optional<Opposite> best;
    if (!m_nodes.empty()) look(0, corner, best, reach);
    return best;
}

} // namespace esm
