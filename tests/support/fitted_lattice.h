#pragma once

#include "core/solid/graded_lattice.h"
#include "core/solid/lattice_springs.h"

#include <memory>

/// A lattice cut to the first body of a surface, with all it was made of.
namespace esm::test {

struct CutLattice {
    std::vector<ClosedBody> bodies;
    std::unique_ptr<BodyQuery> query;
    BackgroundLattice background;
    StuffedLattice lattice;
};

inline CutLattice cutLattice(const TriangleMesh& mesh, LatticeKind kind, double spacing) {
    CutLattice result{closedBodiesOf(mesh), nullptr, {}, {}};
    result.query = std::make_unique<BodyQuery>(result.bodies[0]);
    result.background = kind == LatticeKind::Graded
                            ? gradedLattice(spacing, result.bodies[0], *result.query, {})
                            : uniformLattice(kind, spacing, result.bodies[0], *result.query, {});
    result.lattice = stuffed(result.background, *result.query, {});
    return result;
}

inline double totalVolume(const std::vector<Tetrahedron>& tetrahedra,
                          const std::vector<Eigen::Vector3d>& nodes) {
    double volume = 0;
    for (const Tetrahedron& tetrahedron : tetrahedra)
        volume += volumeOf(tetrahedron, nodes);
    return volume;
}

} // namespace esm::test
