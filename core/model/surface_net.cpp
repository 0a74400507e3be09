#include "core/model/surface_net.h"

#include "core/geometry/adjacency.h"
#include "core/geometry/sorted_by_vertex.h"

#include <algorithm>
#include <numeric>

namespace esm {

namespace {

/// A plane at a node: two directions in it, at right angles and of length 1, as rows.
using NodePlane = Eigen::Matrix<double, 2, 3>;

std::vector<NodePlane> nodePlanes(const std::vector<Eigen::Vector3d>& nodes,
                                  const std::vector<Triangle>& triangles) {
    std::vector<NodePlane> planes;
    planes.reserve(nodes.size());
    for (const Eigen::Vector3d& normal : vertexNormals(nodes, triangles)) {
        const Eigen::Vector3d first = normal.unitOrthogonal();
        planes.emplace_back();
        planes.back() << first.transpose(), normal.cross(first).transpose();
    }
    return planes;
}

NetEnd netEnd(std::uint32_t node, const NodePlane& plane, const Eigen::Vector3d& way) {
    const Eigen::Vector2d seen = plane * way;
    if (!(seen.norm() > 1e-9 * way.norm())) return {node, Eigen::Vector2d::Zero(), 1};
    const Eigen::Vector2d along = seen.normalized();
    const LineDirection once(along.x(), along.y());
    return {node, along, once * once};
}

Edge edgeOf(const Spring& spring) {
    return std::minmax({spring.first, spring.second});
}

/// Finds the spring along an edge when asked for edges in their order.
class SpringsByEdge {
public:
    explicit SpringsByEdge(const std::vector<Spring>& springs) : m_springs(springs), m_order(springs.size()) {
        std::iota(m_order.begin(), m_order.end(), std::size_t{0});
        m_order = sortedByVertex(
            m_order, [&](std::size_t i) { return edgeOf(springs[i]).first; },
            [&](std::size_t i, std::size_t j) { return edgeOf(springs[i]) < edgeOf(springs[j]); });
    }

    std::size_t next(const Edge& edge) {
        while (m_place < m_order.size() && edgeOf(m_springs[m_order[m_place]]) < edge)
            ++m_place;
        const bool isFound = m_place < m_order.size() && edgeOf(m_springs[m_order[m_place]]) == edge;
        return isFound ? m_order[m_place] : m_springs.size();
    }

private:
    const std::vector<Spring>& m_springs;
    std::vector<std::size_t> m_order;
    std::size_t m_place = 0;
};

/// The triangle laid flat, its first edge along the first axis.
NetTriangle netTriangle(const std::vector<Eigen::Vector3d>& nodes, const Triangle& corners) {
    NetTriangle result{corners, {noIndex, noIndex, noIndex}, {1, 1, 1}, 0};
    const Eigen::Vector3d normal = areaNormal(nodes, corners);
    result.area = normal.norm() / 2;
    const Eigen::Vector3d first = (nodes[corners[1]] - nodes[corners[0]]).normalized();
    const Eigen::Vector3d second = normal.normalized().cross(first);
    for (std::size_t i = 1; i < 3; ++i) {
        const Eigen::Vector3d way = nodes[corners[(i + 1) % 3]] - nodes[corners[i]];
        const LineDirection once(way.dot(first), way.dot(second));
        if (std::abs(once) > 0) result.directions[i] = once * once / std::norm(once);
    }
    return result;
}

void putSpring(NetTriangle& triangle, const TriangleSide& side, std::uint32_t spring) {
    const std::uint32_t start = side.forward ? side.edge.first : side.edge.second;
    const auto corner = std::find(triangle.corners.begin(), triangle.corners.end(), start);
    triangle.springs[static_cast<std::size_t>(corner - triangle.corners.begin())] = spring;
}

} // namespace

// Of an edge all that is flat knows is its direction, in the plane of each of its nodes and triangles. That
// is enough to carry a direction from one plane to another: both see the same edge. On a surface that bends
// one way this is unrolling it; where it bends both ways, what is carried around a point comes back turned by
// the point's curvature, which is little from one node to the next.
SurfaceNet surfaceNet(const std::vector<Eigen::Vector3d>& nodes, const std::vector<Spring>& springs,
                      const std::vector<Triangle>& triangles) {
    SurfaceNet net;
    net.isInside.assign(nodes.size(), true);
    net.triangles.reserve(triangles.size());
    for (const Triangle& triangle : triangles)
        net.triangles.push_back(netTriangle(nodes, triangle));
    const std::vector<NodePlane> planes = nodePlanes(nodes, triangles);
    SpringsByEdge springsByEdge(springs);
    forEachEdge(sidesByEdge(triangles), [&](auto first, auto last) {
        const auto [from, to] = first->edge;
        if (last - first != 2) net.isInside[from] = net.isInside[to] = false;
        const std::size_t number = springsByEdge.next(first->edge);
        if (number == springs.size()) return;
        const Eigen::Vector3d way = nodes[to] - nodes[from];
        NetSpring spring{
            number, {netEnd(from, planes[from], way), netEnd(to, planes[to], way)}, way.norm(), 0};
        for (auto side = first; side != last; ++side) {
            spring.area += net.triangles[side->triangle].area;
            putSpring(net.triangles[side->triangle], *side, static_cast<std::uint32_t>(net.springs.size()));
        }
        net.springs.push_back(spring);
    });
    return net;
}

} // namespace esm
