#pragma once

#include "core/texture/atlas/atlas.h"

namespace esm {

/// The layout by the texture coordinates that the mesh brought, on one page. Nothing is moved, so that
/// pictures which others paint for the mesh fit.

/// What keeps the mesh's own places from being painted: none of them, some beyond the picture, some over each
/// other, or no area at all. Empty when all is well. Overlaps are counted on a grid of 2048 × 2048 places,
/// and a thousandth of the area may overlap, as borders do that were rounded.
std::vector<std::string> ownLayoutProblems(const TriangleMesh& mesh);

/// What can be painted and still is worth knowing: triangles mirrored against most others, triangles that
/// have an area on the surface alone and show a single colour.
std::vector<std::string> ownLayoutWarnings(const TriangleMesh& mesh);

/// @throws InvalidModel with all of `ownLayoutProblems()`, and for options that ask for more pages than one
/// or for a density, which are the mesh's own
Atlas ownLayout(const TriangleMesh& mesh, const AtlasOptions& options);

} // namespace esm
