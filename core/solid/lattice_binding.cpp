#include "core/solid/lattice_binding.h"

#include "core/solid/closed_body.h"
#include "core/solid/parallel_nodes.h"
#include "core/support/errors.h"

#include <Eigen/LU>

#include <algorithm>

namespace esm {

namespace {

using Eigen::Vector3d;

// Of all weights with Σw = 1 and Σw·p = x the smallest, nodes counting less the farther away they are: four
// conditions, solved by four multipliers. Of four nodes there is one solution, the barycentric coordinates.
std::vector<double> affineShares(const Vector3d& point, const std::vector<std::uint32_t>& carriers,
                                 const std::vector<Vector3d>& nodes) {
    double reach = 0;
    for (const std::uint32_t node : carriers)
        reach = std::max(reach, (nodes[node] - point).norm());
    const auto count = static_cast<Eigen::Index>(carriers.size());
    Eigen::Matrix4Xd conditions(4, count);
    Eigen::VectorXd mobility(count);
    for (Eigen::Index i = 0; i < count; ++i) {
        const Vector3d away = (nodes[carriers[static_cast<std::size_t>(i)]] - point) / reach;
        conditions.col(i) << 1, away;
        mobility[i] = 1 / (0.01 + away.squaredNorm());
    }
    const Eigen::Matrix4Xd moved = conditions * mobility.asDiagonal();
    const Eigen::Matrix4d system = moved * conditions.transpose();
    const Eigen::VectorXd shares = moved.transpose() * system.fullPivLu().solve(Eigen::Vector4d(1, 0, 0, 0));
    return {shares.data(), shares.data() + count};
}

/// One body of the lattice, ready to carry points of its surface.
class BodyBinder {
public:
    BodyBinder(const std::vector<OuterFace>& faces, const FilledBody& filled)
        : m_faces(faces), m_nodes(filled.nodes), m_rays(m_nodes, trianglesOf(faces)),
          m_starts(m_nodes.size() + 1, 0) {
        for (const LatticeSpring& spring : filled.springs)
            for (const std::uint32_t node : {spring.first, spring.second})
                ++m_starts[node + 1];
        for (std::size_t i = 0; i < m_nodes.size(); ++i)
            m_starts[i + 1] += m_starts[i];
        m_neighbours.resize(2 * filled.springs.size());
        std::vector<std::uint32_t> next(m_starts.begin(), m_starts.end() - 1);
        for (const LatticeSpring& spring : filled.springs) {
            m_neighbours[next[spring.first]++] = spring.second;
            m_neighbours[next[spring.second]++] = spring.first;
        }
    }

    struct Row {
        std::vector<std::uint32_t> nodes;
        std::vector<double> shares;
    };

    Row rowOf(const Vector3d& point) const {
        const OuterFace& face = m_faces[m_rays.nearest(point)->triangle];
        Row row{{face.nodes[0], face.nodes[1], face.nodes[2], face.inner}, {}};
        row.shares = affineShares(point, row.nodes, m_nodes);
        if (*std::min_element(row.shares.begin(), row.shares.end()) >= leastShare) return row;
        for (const std::uint32_t node : face.nodes)
            row.nodes.insert(row.nodes.end(), m_neighbours.begin() + m_starts[node],
                             m_neighbours.begin() + m_starts[node + 1]);
        std::sort(row.nodes.begin(), row.nodes.end());
        row.nodes.erase(std::unique(row.nodes.begin(), row.nodes.end()), row.nodes.end());
        row.shares = affineShares(point, row.nodes, m_nodes);
        return row;
    }

private:
    static std::vector<Triangle> trianglesOf(const std::vector<OuterFace>& faces) {
        std::vector<Triangle> triangles;
        triangles.reserve(faces.size());
        for (const OuterFace& face : faces)
            triangles.push_back(face.nodes);
        return triangles;
    }

    static constexpr double leastShare = -0.3;

    const std::vector<OuterFace>& m_faces;
    const std::vector<Vector3d>& m_nodes;
    SurfaceQuery m_rays;
    std::vector<std::uint32_t> m_starts, m_neighbours; ///< of each node, one after the other
};

} // namespace

// A vertex of the drawn surface lies a little beyond the lattice where the organ bulges, a little within
// where it is hollow. The nearest face of the lattice's surface, of the vertex's own body, names the
// tetrahedron. Extrapolated from it alone, a flat tetrahedron would swing a far vertex about; then all
// neighbours of the face share in it.
Binding bindToLattice(const TriangleMesh& mesh, const FilledBody& filled, const Progress& progress) {
    ProgressParts parts(progress);
    const std::vector<ClosedBody> bodies = closedBodiesOf(mesh);
    if (bodies.size() + 1 != filled.bodyStarts.size())
        throw InvalidModel("the lattice has " + std::to_string(filled.bodyStarts.size() - 1) +
                           " bodies and the surface " + std::to_string(bodies.size()));
    const std::vector<OuterFace> all = outerFaces(filled.tetrahedra);
    std::vector<BodyBinder::Row> rows(mesh.vertices.size(), {{0}, {1}}); // one of no triangle is not drawn
    reportProgress(parts.next(0.3), 1);
    for (std::size_t body = 0; body < bodies.size(); ++body) {
        std::vector<OuterFace> faces;
        for (const OuterFace& face : all)
            if (face.inner >= filled.bodyStarts[body] && face.inner < filled.bodyStarts[body + 1])
                faces.push_back(face);
        const BodyBinder binder(faces, filled);
        const std::vector<std::uint32_t>& vertices = bodies[body].vertices;
        const double share =
            0.6 * static_cast<double>(vertices.size()) / static_cast<double>(mesh.vertices.size());
        forEachNode(vertices.size(), parts.next(share),
                    [&](std::size_t i) { rows[vertices[i]] = binder.rowOf(mesh.vertices[vertices[i]]); });
    }
    Binding binding;
    for (const BodyBinder::Row& row : rows)
        binding.vertices.add({row.nodes, row.shares});
    reportProgress(parts.rest(), 1);
    return binding;
}

} // namespace esm
