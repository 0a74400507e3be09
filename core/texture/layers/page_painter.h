#pragma once

#include "core/support/progress.h"
#include "core/texture/atlas/atlas.h"
#include "core/texture/layers/layer_stack.h"
#include "core/texture/layers/texel_owners.h"
#include "core/texture/layers/tiled_pages.h"

namespace esm {

/// Shares of composing that come before painting: what the stack of layers makes once, and who owns the
/// texels. Both are kept, and take no time where only layers changed that lie there already.
constexpr double stackShare = 0.4, ownersShare = 0.1;

/// Marks of triangles, not 0 where one is meant.
using TriangleMarks = std::vector<std::uint8_t>;

/// Fills the texels of the patches and around them.
/// @param only the triangles whose texels are filled; of all that layers reach, where empty
/// @throws Cancelled
template<typename Channel>
void paintPages(const LayerStack& stack, const Atlas& atlas, const TexelOwners& owners,
                const TriangleMarks& only, std::vector<ImageOf<Channel>>& pages, const Progress& progress);

/// The same into tiles; those in which nothing is painted stay.
void paintPages(const LayerStack& stack, const Atlas& atlas, const TexelOwners& owners,
                const TriangleMarks& only, TiledPages& pages, const Progress& progress);

/// Makes the red of what the layers come to the alpha of the texels that they reach.
void paintAlpha(const LayerStack& stack, const Atlas& atlas, const TexelOwners& owners, TiledPages& pages,
                const Progress& progress);

extern template void paintPages(const LayerStack&, const Atlas&, const TexelOwners&, const TriangleMarks&,
                                std::vector<Image>&, const Progress&);
extern template void paintPages(const LayerStack&, const Atlas&, const TexelOwners&, const TriangleMarks&,
                                std::vector<DeepImage>&, const Progress&);

} // namespace esm
