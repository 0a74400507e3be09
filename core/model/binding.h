#pragma once

#include "core/geometry/simplified_mesh.h"
#include "core/support/progress.h"

#include <span>
#include <string>
#include <vector>

namespace esm {

/// The nodes that carry one vertex of the drawn mesh, and their shares, sum 1; below 0 only beyond nodes.
struct VertexBinding {
    std::span<const std::uint32_t> nodes;
    std::span<const double> shares; ///< as many
};

/// A row of nodes and shares per vertex of the drawn mesh, of any length, one row after the other as in a
/// compressed sparse matrix. A place that is not needed may repeat a node with the share 0.
struct BindingRows {
    std::vector<std::uint32_t> starts{0}; ///< where each row begins; then where the last one ends
    std::vector<std::uint32_t> nodes;
    std::vector<double> shares;

    std::size_t size() const { return starts.empty() ? 0 : starts.size() - 1; }
    /// Precondition: validate() finds nothing wrong with the rows.
    VertexBinding operator[](std::size_t vertex) const;
    void add(const VertexBinding& vertex);
    bool operator==(const BindingRows&) const = default;
};

/// How other nodes than the drawn mesh's vertices carry it, fewer ones or those of a lattice: "visible
/// vertices are a subset of the nodes; simulated and drawn mesh need not be the same".
///
/// With p⁰ and p a node's place at rest and now, x⁰ a vertex at rest, and w its nodes' shares, the vertex is
/// at x = x⁰ + Σ w·((p − p⁰) + (G − 1)·(x⁰ − p⁰)). G says how the surroundings of a node turn and stretch:
/// the mean, weighted by area at rest, of the deformation of the triangles at the node, which takes their
/// sides to where they are now and their unit normals to the present ones. At the ends of a line, G is the
/// smallest rotation from the line's direction at rest to the present one. Elsewhere it is 1: such nodes, as
/// a lattice has them, follow a turn by their places alone, exactly where Σ w·p⁰ = x⁰.
struct Binding {
    std::vector<Triangle> surface; ///< over the nodes: what is simulated of the surface
    std::vector<Edge> lines;       ///< two nodes each
    BindingRows vertices;          ///< one per vertex of the drawn mesh
};

/// Binds every vertex to the triangle of the simulated surface that is nearest among those which face the
/// same way and lie around the kept vertex it is nearest to along the drawn edges: to its own part, and to
/// its own side of thin tissue. Node i is `simulated.vertices[i]`.
/// @throws Cancelled
Binding bindToSurface(const TriangleMesh& drawn, const SimplifiedMesh& simulated,
                      const Progress& progress = {});

/// Binds all vertices to the middle and direction of the line between two nodes: they move as one rigid body
/// [R 5.1].
Binding bindToLine(std::size_t vertexCount, const Edge& line);

/// Whether all vertices hang on the ends of one line: they are one piece that moves with it.
bool isOnOneLine(const Binding& binding);

/// The node with the largest share in each vertex.
std::vector<std::uint32_t> mainNodes(const Binding& binding);

/// Where the nodes carry the drawn vertices, m. Finite for finite positions, also where triangles have no
/// area any more. Precondition: a valid binding for these vertices and nodes.
std::vector<Eigen::Vector3d> carried(const std::vector<Eigen::Vector3d>& restVertices, const Binding& binding,
                                     const std::vector<Eigen::Vector3d>& restPositions,
                                     const std::vector<Eigen::Vector3d>& positions);

/// Every problem of a binding. Empty when it can carry that many vertices by that many nodes.
std::vector<std::string> validate(const Binding& binding, std::size_t vertexCount, std::size_t nodeCount);

} // namespace esm
