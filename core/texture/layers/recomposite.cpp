#include "core/support/errors.h"
#include "core/texture/layers/changed_triangles.h"
#include "core/texture/layers/composite.h"
#include "core/texture/layers/page_painter.h"
#include "core/texture/texture_limits.h"

#include <algorithm>

namespace esm {

namespace {

constexpr double changedShare = 0.2; ///< of the work

bool belongTo(const TiledPages& pages, const Atlas& atlas) {
    return pages.size() == static_cast<std::size_t>(atlas.options.pages) &&
           std::all_of(pages.begin(), pages.end(), [&](const TiledImage& page) {
               return page.width() == atlas.options.size && page.height() == atlas.options.size;
           });
}

TiledPages emptyPages(const Atlas& atlas, const std::array<std::uint8_t, 3>& colour) {
    const TiledImage page(atlas.options.size, atlas.options.size, pageTile,
                          {colour[0], colour[1], colour[2], 255});
    return TiledPages(static_cast<std::size_t>(atlas.options.pages), page);
}

bool hasAny(const TriangleMarks& marks) {
    return std::any_of(marks.begin(), marks.end(), [](std::uint8_t mark) { return mark != 0; });
}

} // namespace

/// Where it is not certain that the pages before are of this atlas and base colour, all is composed. What is
/// marked may be more than what has changed, never less: a texel composed again comes out as it was.
TiledPages recomposite(const TriangleMesh& mesh, const Atlas& atlas, const Composition& before,
                       const std::vector<TextureLayer>& layers, std::array<std::uint8_t, 3> baseColour,
                       CompositionCache& cache, const Progress& progress) {
    const std::vector<std::string> problems = validate(atlas, mesh.triangles.size());
    if (!problems.empty()) throw InvalidModel(problems);
    const bool canGoOn = before.pages && before.baseColour == baseColour && belongTo(*before.pages, atlas);
    ProgressParts parts(progress);
    const Progress comparing = parts.next(canGoOn ? changedShare : 0);
    TriangleMarks changed; // where it has none, all that layers reach
    if (canGoOn) changed = changedTriangles(mesh, atlas.corners, before.layers, layers, cache, comparing);
    const LayerStack stack(mesh, atlas.corners, layers, baseColour, cache, parts.next(stackShare));
    TiledPages pages = canGoOn ? *before.pages : emptyPages(atlas, baseColour);
    const Progress owning = parts.next(ownersShare), painting = parts.rest();
    if (canGoOn ? hasAny(changed) : !stack.isEmpty())
        paintPages(stack, atlas, *cache.ownersOf(mesh, atlas, owning), changed, pages, painting);
    cache.finish();
    reportProgress(progress, 1);
    return pages;
}

} // namespace esm
