#pragma once

#include "core/support/progress.h"
#include "core/texture/atlas/atlas.h"
#include "core/texture/layers/texel_owners.h"
#include "core/texture/layers/tiled_pages.h"

#include <vector>

namespace esm {

/// Texels between patches that are filled with their colours, half from either side.
double filledGap(const AtlasOptions& options);

/// How often a page can be halved before the bilinear filter, which reads a texel around its place, reaches
/// beyond the middle of the gap into a neighbour's border. Never in a mesh's own layout, which keeps no gap.
int usableLevels(const AtlasOptions& options);

/// Texels by which a place is moved into its patch where a page halved so often is read, so that the wide
/// texels around it still show the patch; 0 where the page itself is read.
double levelInset(const AtlasOptions& options, int halvings);

using SmallerPages = std::vector<std::vector<TiledImage>>; ///< of each page, the largest first

/// Pages and what was made of them.
struct HalvedPages {
    TiledPages pages;
    SmallerPages smaller;
};

/// The pages of a texture, each at half its size, at a quarter and so on as far as the gap allows. A texel
/// shows the patch nearest to its centre, by the mean of those texels in it that belong to that patch, so
/// that no patch mixes with another [R 4.3.2.4]. A patch is all triangles that lie side by side in the
/// texture as on the surface. Pure, and the same with any number of threads.
/// @throws InvalidModel for a layout beyond its pages or pages of another size; Cancelled
SmallerPages smallerPages(const TriangleMesh& mesh, const Atlas& atlas, const TiledPages& pages,
                          const Progress& progress = {});

/// The same, where `before` are other pages of the same atlas and what was made of them, or nothing: only
/// where their tiles differ is anything computed.
/// @param owners of the atlas
SmallerPages smallerPages(const Atlas& atlas, const TexelOwners& owners, const TiledPages& pages,
                          const HalvedPages& before, const Progress& progress = {});

} // namespace esm
