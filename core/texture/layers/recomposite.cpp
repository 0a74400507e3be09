#include "core/texture/layers/changed_triangles.h"
#include "core/texture/layers/composite.h"
#include "core/texture/layers/page_painter.h"
#include "core/texture/texture_limits.h"

#include <algorithm>

namespace esm {

namespace {

constexpr double changedShare = 0.2; ///< of the work

bool belongTo(const std::vector<Image>& pages, const Atlas& atlas) {
    return pages.size() == static_cast<std::size_t>(atlas.options.pages) &&
           std::all_of(pages.begin(), pages.end(), [&](const Image& page) {
               return page.width == atlas.options.size && page.height == atlas.options.size;
           });
}

} // namespace

/// Where it is not certain that the pages before are of this atlas and base colour, all is composed. What is
/// marked may be more than what has changed, never less: a texel composed again comes out as it was.
std::vector<Image> recomposite(const TriangleMesh& mesh, const Atlas& atlas, const Composition& before,
                               const std::vector<TextureLayer>& layers,
                               std::array<std::uint8_t, 3> baseColour, CompositionCache& cache,
                               const Progress& progress) {
    const bool canGoOn = before.pages && before.baseColour == baseColour && belongTo(*before.pages, atlas) &&
                         validate(atlas, mesh.triangles.size()).empty();
    if (!canGoOn) return composite(mesh, atlas, layers, baseColour, cache, progress);
    ProgressParts parts(progress);
    const TriangleMarks changed =
        changedTriangles(mesh, atlas.corners, before.layers, layers, cache, parts.next(changedShare));
    const LayerStack stack(mesh, atlas.corners, layers, baseColour, cache, parts.next(stackShare));
    std::vector<Image> pages = *before.pages;
    const Progress owning = parts.next(ownersShare), painting = parts.rest();
    paintPages(stack, atlas, *cache.ownersOf(atlas, owning), changed, pages, painting);
    cache.finish();
    return pages;
}

} // namespace esm
