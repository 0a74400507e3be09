#pragma once

#include "core/model/binding.h"
#include "core/solid/filled_body.h"

namespace esm {

/// How the nodes of a filled body carry the surface that was filled: every vertex by the nodes of the
/// tetrahedron under it, and by more of them where it lies far beyond. Shares sum up to 1 and reproduce the
/// vertex, Σ w·p⁰ = x⁰, so that it follows a rigid motion and any linear one exactly; beyond the nodes some
/// are negative. No node turns its surroundings: the binding has no triangles (`Lattice::surface` has what
/// can be touched).
/// @param mesh the surface that was filled
/// @throws InvalidModel where it cannot have been; Cancelled
Binding bindToLattice(const TriangleMesh& mesh, const FilledBody& filled, const Progress& progress = {});

} // namespace esm
