#include "core/solid/relaxation.h"

#include "core/solid/parallel_nodes.h"

#include <algorithm>
#include <cmath>

namespace esm {

namespace {

using Eigen::Vector3d;

constexpr double leastShape = 0.3; ///< below, a tetrahedron may not become worse
// Forty sweeps leave some nodes moving by 1 % of the spacing on the roughest organs, most are done after ten.
constexpr int mostSweeps = 40;
constexpr double settledMove = 0.005; ///< of the spacing: a node that would move less stays

/// A spring as one of its nodes sees it.
struct SpringEnd {
    std::uint32_t other;
    double constant, length; ///< length at rest, m
};

class Relaxing {
public:
    Relaxing(StuffedLattice& lattice, const std::vector<FittedSpring>& springs, const BodyQuery& query,
             double spacing)
        : m_lattice(lattice), m_query(query), m_spacing(spacing), m_starts(lattice.nodes.size() + 1, 0),
          m_isMoved(lattice.nodes.size(), 0), m_normals(lattice.nodes.size(), Vector3d::Zero()) {
        for (const FittedSpring& fitted : springs)
            for (const std::uint32_t node : {fitted.spring.first, fitted.spring.second})
                ++m_starts[node + 1];
        for (std::size_t i = 0; i < lattice.nodes.size(); ++i)
            m_starts[i + 1] += m_starts[i];
        m_ends.resize(2 * springs.size());
        std::vector<std::uint32_t> next(m_starts.begin(), m_starts.end() - 1);
        for (const FittedSpring& fitted : springs) {
            const auto& [first, second, constant] = fitted.spring;
            const double present = (lattice.nodes[first] - lattice.nodes[second]).norm();
            const double length =
                fitted.latticeLength > 0 ? fitted.latticeLength : std::max(present, leastLength * spacing);
            m_ends[next[first]++] = {second, constant, length};
            m_ends[next[second]++] = {first, constant, length};
        }
        forEachNode(lattice.nodes.size(), {}, [&](std::size_t i) {
            if (lattice.isOnSurface[i]) m_normals[i] = query.normalOf(query.nearest(lattice.nodes[i]));
        });
        for (const Tetrahedron& nodes : lattice.tetrahedra)
            m_shapes.push_back(std::min(leastShape, shapeOf(nodes, lattice.nodes)));
    }

    /// @return whether any node moved
    bool sweep() {
        const std::vector<Vector3d> before = m_lattice.nodes;
        forEachNode(before.size(), {}, [&](std::size_t i) {
            const Vector3d place = moved(i, before);
            m_isMoved[i] = (place - before[i]).norm() > settledMove * m_spacing;
            if (m_isMoved[i]) m_lattice.nodes[i] = m_lattice.isOnSurface[i] ? onSurface(i, place) : place;
        });
        while (takeBack(before)) {
        }
        return std::find(m_isMoved.begin(), m_isMoved.end(), 1) != m_isMoved.end();
    }

private:
    // A step of Jacobi's way, which each node takes by itself; of a node on the surface what would lift it
    // off is left out, since that does not move it.
    Vector3d moved(std::size_t node, const std::vector<Vector3d>& nodes) const {
        Vector3d force = Vector3d::Zero();
        double stiffness = 0;
        for (std::uint32_t i = m_starts[node]; i < m_starts[node + 1]; ++i) {
            const Vector3d along = nodes[m_ends[i].other] - nodes[node];
            const double length = along.norm();
            force += m_ends[i].constant * (1 - m_ends[i].length / length) * along;
            stiffness += m_ends[i].constant;
        }
        if (!(stiffness > 0)) return nodes[node];
        Vector3d move = force / stiffness;
        move -= move.dot(m_normals[node]) * m_normals[node];
        const double farthest = 0.1 * m_spacing;
        if (move.norm() > farthest) move *= farthest / move.norm();
        return nodes[node] + move;
    }

    /// Back to the surface from a place beside it.
    Vector3d onSurface(std::size_t node, const Vector3d& place) {
        const RayHit hit = m_query.nearest(place);
        m_normals[node] = m_query.normalOf(hit);
        return m_query.placeOf(hit);
    }

    bool isSpoilt(std::size_t tetrahedron) const {
        const Tetrahedron& nodes = m_lattice.tetrahedra[tetrahedron];
        return std::any_of(nodes.begin(), nodes.end(), [&](auto node) { return m_isMoved[node]; }) &&
               shapeOf(nodes, m_lattice.nodes) < m_shapes[tetrahedron];
    }

    // Taking a node back may spoil a tetrahedron beside it, which is seen when all are looked at again. Each
    // time more nodes are where they were, so that it ends.
    /// Puts nodes of spoilt tetrahedra back. @return whether there were any
    bool takeBack(const std::vector<Vector3d>& before) {
        std::vector<char> spoilt(m_lattice.tetrahedra.size());
        forEachNode(spoilt.size(), {}, [&](std::size_t i) { spoilt[i] = isSpoilt(i) ? 1 : 0; });
        bool isAny = false;
        for (std::size_t i = 0; i < spoilt.size(); ++i) {
            if (!spoilt[i]) continue;
            isAny = true;
            for (const std::uint32_t node : m_lattice.tetrahedra[i]) {
                m_lattice.nodes[node] = before[node];
                m_isMoved[node] = 0;
            }
        }
        return isAny;
    }

    static constexpr double leastLength = 0.7; ///< of the spacing, what a cut spring stretches to

    StuffedLattice& m_lattice;
    const BodyQuery& m_query;
    double m_spacing;
    std::vector<std::uint32_t> m_starts; ///< where each node's ends begin; then the end
    std::vector<SpringEnd> m_ends;
    std::vector<char> m_isMoved;     ///< per node, in this sweep
    std::vector<Vector3d> m_normals; ///< of the surface, per node on it; 0 within
    std::vector<double> m_shapes;    ///< what each tetrahedron must not fall below
};

} // namespace

double shapeOf(const Tetrahedron& tetrahedron, const std::vector<Vector3d>& nodes) {
    double squares = 0;
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = i + 1; j < 4; ++j)
            squares += (nodes[tetrahedron[i]] - nodes[tetrahedron[j]]).squaredNorm() / 6;
    return volumeOf(tetrahedron, nodes) * 6 * std::sqrt(2.0) / (squares * std::sqrt(squares));
}

// [R 3.3.1.3] Springs at rest where the lattice has them push what was drawn and cut apart. Nodes move
// towards equilibrium all at once, each by its own springs; those on the surface then go to its nearest
// point. Where a tetrahedron would suffer, its nodes go back to where they were before this sweep, and so on
// until none does: at the worst nothing moves.
void relax(StuffedLattice& lattice, const std::vector<FittedSpring>& springs, const BodyQuery& query,
           double spacing, const Progress& progress) {
    Relaxing relaxing(lattice, springs, query, spacing);
    for (int i = 0; i < mostSweeps; ++i) {
        reportProgress(progress, double(i) / mostSweeps);
        if (!relaxing.sweep()) break;
    }
    reportProgress(progress, 1);
}

} // namespace esm
