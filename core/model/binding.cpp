#include "core/model/binding.h"

#include "core/geometry/nearest_weights.h"
#include "core/geometry/shortest_turn.h"
#include "core/support/offenders.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <queue>

namespace esm {

namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Points = std::vector<Vector3d>;

constexpr double shareTolerance = 1e-6; ///< of their sum: 32-bit numbers of a package come to no more
/// A vertex beyond the nodes that carry it has negative shares and others above 1. Beyond this a node that
/// moves a little would swing it about.
constexpr double largestShare = 4;

std::vector<std::vector<std::uint32_t>> neighboursOf(const std::vector<Triangle>& triangles,
                                                     std::size_t vertexCount) {
    std::vector<std::vector<std::uint32_t>> neighbours(vertexCount);
    for (const Edge& edge : uniqueEdges(triangles)) {
        neighbours[edge.first].push_back(edge.second);
        neighbours[edge.second].push_back(edge.first);
    }
    return neighbours;
}

/// The node that is nearest to each vertex along the edges; noIndex where none can be reached. Dijkstra's way
/// (1959) from all nodes at once. Along the edges, not through space: a node of the opposite wall of thin
/// tissue may be nearer through space, and would carry the vertex with the wrong wall.
std::vector<std::uint32_t> nearestNodes(const TriangleMesh& mesh, const std::vector<std::uint32_t>& kept) {
    const auto neighbours = neighboursOf(mesh.triangles, mesh.vertices.size());
    std::vector<std::uint32_t> nodes(mesh.vertices.size(), noIndex);
    std::vector<double> distances(mesh.vertices.size(), std::numeric_limits<double>::infinity());
    using Reached = std::pair<double, std::uint32_t>;
    std::priority_queue<Reached, std::vector<Reached>, std::greater<>> front;
    for (std::uint32_t node = 0; node < kept.size(); ++node) {
        nodes[kept[node]] = node;
        distances[kept[node]] = 0;
        front.emplace(0, kept[node]);
    }
    while (!front.empty()) {
        const auto [distance, vertex] = front.top();
        front.pop();
        if (distance > distances[vertex]) continue;
        for (const std::uint32_t next : neighbours[vertex]) {
            const double farther = distance + (mesh.vertices[next] - mesh.vertices[vertex]).norm();
            if (farther >= distances[next]) continue;
            distances[next] = farther;
            nodes[next] = nodes[vertex];
            front.emplace(farther, next);
        }
    }
    return nodes;
}

/// For every node the triangles at it and at its neighbours, ascending. The node nearest to a vertex need not
/// be a corner of the triangle that lies under it; its neighbours' triangles are therefore tried as well, a
/// dozen or two in place of all.
std::vector<std::vector<std::uint32_t>> trianglesAround(const std::vector<Triangle>& triangles,
                                                        std::size_t nodeCount) {
    std::vector<std::vector<std::uint32_t>> at(nodeCount), around(nodeCount);
    for (std::uint32_t i = 0; i < triangles.size(); ++i)
        for (const std::uint32_t node : triangles[i])
            at[node].push_back(i);
    const auto neighbours = neighboursOf(triangles, nodeCount);
    for (std::size_t node = 0; node < nodeCount; ++node) {
        around[node] = at[node];
        for (const std::uint32_t next : neighbours[node])
            around[node].insert(around[node].end(), at[next].begin(), at[next].end());
        std::sort(around[node].begin(), around[node].end());
        around[node].erase(std::unique(around[node].begin(), around[node].end()), around[node].end());
    }
    return around;
}

/// What a vertex needs to hang on a triangle.
struct ThreeNodes {
    Triangle nodes;
    std::array<double, 3> shares;
};

ThreeNodes onNode(std::uint32_t node) {
    return {{node, node, node}, {1, 0, 0}};
}

/// A point of the drawn mesh and where it faces.
struct FacingPoint {
    const Vector3d& place;
    const Vector3d& normal;
};

/// To the nearest of the candidates that face as the point does, the first where two are as near; to its node
/// where none does.
ThreeNodes toNearest(const FacingPoint& point, const TriangleMesh& coarse,
                     const std::vector<std::uint32_t>& candidates, std::uint32_t node) {
    ThreeNodes binding = onNode(node);
    double nearest = std::numeric_limits<double>::infinity();
    for (const std::uint32_t candidate : candidates) {
        const Triangle& nodes = coarse.triangles[candidate];
        const Vector3d &a = coarse.vertices[nodes[0]], &b = coarse.vertices[nodes[1]],
                       &c = coarse.vertices[nodes[2]];
        if ((b - a).cross(c - a).dot(point.normal) < 0) continue;
        Vector3d shares = nearestWeights(point.place, a, b, c).cwiseMax(0);
        shares /= shares.sum();
        const double distance = (shares[0] * a + shares[1] * b + shares[2] * c - point.place).squaredNorm();
        if (!(distance < nearest)) continue;
        nearest = distance;
        binding = {nodes, {shares[0], shares[1], shares[2]}};
    }
    return binding;
}

/// What turns and stretches with the nodes: sums over all that has a say in a node's surroundings.
///
/// Were vertices moved by their nodes' displacements alone, what stands out from the coarse surface would not
/// turn with it: bumps would be sheared where tissue bends. Each node therefore has a frame, and a vertex
/// takes the weighted mean of where its nodes' frames would carry it (linear blend skinning). A frame is the
/// mean over the triangles at a node, so that it has no jump from one triangle to the next.
class Surroundings {
public:
    Surroundings(const Points& rest, const Points& now)
        : m_rest(rest), m_now(now), m_sums(rest.size(), Matrix3d::Zero()), m_weights(rest.size(), 0.0) {}

    // The deformation takes side to sideNow, other to otherNow and normal to normalNow: F = Σ now ⊗ dual,
    // with the dual basis side* = other × normal/A, other* = normal × side/A, normal* = normal, where A =
    // |side × other|. It is summed up times A, its weight in the mean, so that the division by the area of a
    // sliver cancels.
    void addTriangle(const Triangle& nodes) {
        const Vector3d side = m_rest[nodes[1]] - m_rest[nodes[0]],
                       other = m_rest[nodes[2]] - m_rest[nodes[0]];
        const Vector3d areaNormal = side.cross(other);
        const double area = areaNormal.norm();
        if (!(area > 0)) return;
        const Vector3d normal = areaNormal / area;
        const Vector3d sideNow = m_now[nodes[1]] - m_now[nodes[0]],
                       otherNow = m_now[nodes[2]] - m_now[nodes[0]];
        Vector3d normalNow = sideNow.cross(otherNow);
        const double areaNow = normalNow.norm();
        // What has shrunk to a line faces nowhere.
        normalNow = areaNow > 0 ? Vector3d(normalNow / areaNow) : Vector3d(Vector3d::Zero());
        const Matrix3d deformation = sideNow * other.cross(normal).transpose() +
                                     otherNow * normal.cross(side).transpose() +
                                     area * normalNow * normal.transpose();
        for (const std::uint32_t node : nodes)
            add(node, deformation, area);
    }

    void addLine(const Edge& line) {
        const Vector3d rest = m_rest[line.second] - m_rest[line.first],
                       now = m_now[line.second] - m_now[line.first];
        if (!(rest.norm() > 0) || !(now.norm() > 0)) return;
        for (const std::uint32_t node : {line.first, line.second})
            add(node, shortestTurn(rest, now), 1);
    }

    // A node without triangles and lines has no surroundings: it takes its vertices along without turning
    // them.
    /// G − 1 for every node.
    std::vector<Matrix3d> changes() const {
        std::vector<Matrix3d> changes(m_sums.size(), Matrix3d::Zero());
        for (std::size_t node = 0; node < changes.size(); ++node)
            if (m_weights[node] > 0) changes[node] = m_sums[node] / m_weights[node] - Matrix3d::Identity();
        return changes;
    }

private:
    void add(std::uint32_t node, const Matrix3d& weighted, double weight) {
        m_sums[node] += weighted;
        m_weights[node] += weight;
    }

    const Points &m_rest, &m_now;
    std::vector<Matrix3d> m_sums;
    std::vector<double> m_weights;
};

bool isSound(const VertexBinding& vertex, std::size_t nodeCount) {
    const auto& [nodes, shares] = vertex;
    return *std::max_element(nodes.begin(), nodes.end()) < nodeCount &&
           std::all_of(shares.begin(), shares.end(),
                       [](double share) { return std::abs(share) <= largestShare; }) &&
           std::abs(std::accumulate(shares.begin(), shares.end(), 0.0) - 1) <= shareTolerance;
}

/// Whether rows lie one behind the other, none of them empty, from 0 to where nodes and shares end.
bool areRows(const BindingRows& rows) {
    const std::vector<std::uint32_t>& starts = rows.starts;
    return !starts.empty() && starts.front() == 0 &&
           std::adjacent_find(starts.begin(), starts.end(), std::greater_equal<>()) == starts.end() &&
           starts.back() == rows.nodes.size() && rows.nodes.size() == rows.shares.size();
}

void reportVertices(std::vector<std::string>& problems, const BindingRows& rows, std::size_t nodeCount) {
    if (!areRows(rows)) {
        problems.emplace_back("the starts of the rows of nodes that carry drawn points should begin with 0, "
                              "rise, and end with the number of nodes and shares");
        return;
    }
    reportOffenders(problems, "drawn point", "whose nodes do not exist or whose shares are not of one",
                    placesWhere(rows.size(), [&](std::size_t i) { return !isSound(rows[i], nodeCount); }));
}

} // namespace

VertexBinding BindingRows::operator[](std::size_t vertex) const {
    const std::uint32_t start = starts[vertex], count = starts[vertex + 1] - start;
    return {std::span(nodes).subspan(start, count), std::span(shares).subspan(start, count)};
}

void BindingRows::add(const VertexBinding& vertex) {
    nodes.insert(nodes.end(), vertex.nodes.begin(), vertex.nodes.end());
    shares.insert(shares.end(), vertex.shares.begin(), vertex.shares.end());
    starts.push_back(static_cast<std::uint32_t>(nodes.size()));
}

// A vertex that is a node hangs on it alone, so that it shows the node's place to the last bit. Every other
// one is looked for along the surface first and in space only then: the shortest way over edges says on which
// part and wall of the organ it lies, the nearest point says where there.
Binding bindToSurface(const TriangleMesh& drawn, const SimplifiedMesh& simulated, const Progress& progress) {
    ProgressParts parts(progress);
    reportProgress(progress, 0);
    TriangleMesh coarse{{}, simulated.triangles};
    for (const std::uint32_t vertex : simulated.vertices)
        coarse.vertices.push_back(drawn.vertices[vertex]);
    const std::vector<std::uint32_t> nodes = nearestNodes(drawn, simulated.vertices);
    reportProgress(parts.next(0.15), 1);
    const auto candidates = trianglesAround(coarse.triangles, coarse.vertices.size());
    reportProgress(parts.next(0.15), 1);
    const Points normals = vertexNormals(drawn.vertices, drawn.triangles);
    const Progress binds = parts.rest();
    Binding binding;
    binding.surface = simulated.triangles;
    binding.vertices.starts.reserve(drawn.vertices.size() + 1);
    binding.vertices.nodes.reserve(3 * drawn.vertices.size());
    binding.vertices.shares.reserve(3 * drawn.vertices.size());
    for (std::uint32_t vertex = 0; vertex < drawn.vertices.size(); ++vertex) {
        reportStep(binds, vertex, drawn.vertices.size());
        // A vertex of no triangle belongs to no part.
        const std::uint32_t node = nodes[vertex] == noIndex ? 0 : nodes[vertex];
        const bool isKept = simulated.vertices[node] == vertex;
        const ThreeNodes three =
            isKept ? onNode(node)
                   : toNearest({drawn.vertices[vertex], normals[vertex]}, coarse, candidates[node], node);
        binding.vertices.add({three.nodes, three.shares});
    }
    return binding;
}

Binding bindToLine(std::size_t vertexCount, const Edge& line) {
    const ThreeNodes middle{{line.first, line.second, line.second}, {0.5, 0.5, 0}};
    Binding binding{{}, {line}, {}};
    for (std::size_t vertex = 0; vertex < vertexCount; ++vertex)
        binding.vertices.add({middle.nodes, middle.shares});
    return binding;
}

bool isOnOneLine(const Binding& binding) {
    const std::vector<std::uint32_t>& nodes = binding.vertices.nodes;
    return binding.surface.empty() && binding.lines.size() == 1 &&
           std::all_of(nodes.begin(), nodes.end(), [&](std::uint32_t node) {
               return node == binding.lines[0].first || node == binding.lines[0].second;
           });
}

std::vector<std::uint32_t> mainNodes(const Binding& binding) {
    std::vector<std::uint32_t> nodes;
    nodes.reserve(binding.vertices.size());
    for (std::size_t vertex = 0; vertex < binding.vertices.size(); ++vertex) {
        const auto& [carrying, shares] = binding.vertices[vertex];
        const auto largest = std::max_element(shares.begin(), shares.end()) - shares.begin();
        nodes.push_back(carrying[static_cast<std::size_t>(largest)]);
    }
    return nodes;
}

Points carried(const Points& restVertices, const Binding& binding, const Points& restPositions,
               const Points& positions) {
    Surroundings surroundings(restPositions, positions);
    for (const Triangle& triangle : binding.surface)
        surroundings.addTriangle(triangle);
    for (const Edge& line : binding.lines)
        surroundings.addLine(line);
    const std::vector<Matrix3d> changes = surroundings.changes();
    const auto& [starts, nodes, shares] = binding.vertices;
    Points vertices = restVertices;
    std::size_t place = 0;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        const Vector3d rest = vertices[i];
        Vector3d vertex = rest;
        for (const std::size_t end = starts[i + 1]; place < end; ++place) {
            const std::uint32_t node = nodes[place];
            vertex += shares[place] *
                      (positions[node] - restPositions[node] + changes[node] * (rest - restPositions[node]));
        }
        vertices[i] = vertex;
    }
    return vertices;
}

std::vector<std::string> validate(const Binding& binding, std::size_t vertexCount, std::size_t nodeCount) {
    std::vector<std::string> problems;
    if (binding.vertices.size() != vertexCount)
        problems.push_back(std::to_string(binding.vertices.size()) + " of " + std::to_string(vertexCount) +
                           " drawn vertices are carried");
    reportVertices(problems, binding.vertices, nodeCount);
    reportOffenders(problems, "simulated triangle", "with a node that does not exist",
                    placesWhere(binding.surface.size(), [&](std::size_t i) {
                        const Triangle& nodes = binding.surface[i];
                        return *std::max_element(nodes.begin(), nodes.end()) >= nodeCount;
                    }));
    reportOffenders(problems, "line", "without two nodes that exist",
                    placesWhere(binding.lines.size(), [&](std::size_t i) {
                        const Edge& line = binding.lines[i];
                        return std::max(line.first, line.second) >= nodeCount || line.first == line.second;
                    }));
    return problems;
}

} // namespace esm
