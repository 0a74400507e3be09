#include "core/texture/layers/composite.h"

#include "core/support/errors.h"
#include "core/texture/layers/page_painter.h"
#include "core/texture/layers/patch_scan.h"
#include "core/texture/texture_limits.h"

#include <algorithm>
#include <limits>
#include <tbb/parallel_for.h>

namespace esm {

namespace {

/// Half a texel's diagonal: a patch within it touches the texel, even where it is too small to hold any
/// centre.
constexpr double touching = 0.70711;

/// The least weight that counts as covering: it turns black into the next grey.
constexpr float leastSeenWeight = 1.0F / 255;

void checkAtlas(const TriangleMesh& mesh, const Atlas& atlas) {
    const std::vector<std::string> problems = validate(atlas, mesh.triangles.size());
    if (!problems.empty()) throw InvalidModel(problems);
}

/// 65535 is 257 · 255, so that 16 bits meet every colour of 8 bits exactly.
template<typename Channel> ImageOf<Channel> filledPage(int size, const std::array<std::uint8_t, 3>& colour) {
    constexpr Channel opaque = std::numeric_limits<Channel>::max();
    ImageOf<Channel> page;
    page.width = page.height = size;
    page.pixels.resize(4 * static_cast<std::size_t>(size) * static_cast<std::size_t>(size), opaque);
    for (std::size_t i = 0; i < page.pixels.size(); i += 4)
        for (std::size_t channel = 0; channel < 3; ++channel)
            page.pixels[i + channel] = static_cast<Channel>(colour[channel] * (opaque / 255));
    return page;
}

/// From the surface [R 4.3.2.3]: each texel of a patch asks the layers for the colour of its place. The other
/// way round, from the pixels of photos to the texels that they fall on, texels would stay empty wherever a
/// photo is coarser than the page.
template<typename Channel>
std::vector<ImageOf<Channel>>
composed(const TriangleMesh& mesh, const Atlas& atlas, const std::vector<TextureLayer>& layers,
         std::array<std::uint8_t, 3> baseColour, CompositionCache& cache, const Progress& progress) {
    ProgressParts parts(progress);
    reportProgress(progress, 0);
    checkAtlas(mesh, atlas);
    const LayerStack stack(mesh, atlas.corners, layers, baseColour, cache, parts.next(stackShare));
    std::vector<ImageOf<Channel>> pages;
    pages.reserve(static_cast<std::size_t>(atlas.options.pages));
    const Progress filling = parts.next(0.05);
    for (int page = 0; page < atlas.options.pages; ++page) {
        reportProgress(filling, static_cast<double>(page) / atlas.options.pages);
        pages.push_back(filledPage<Channel>(atlas.options.size, baseColour));
    }
    const Progress owning = parts.next(ownersShare), painting = parts.rest();
    if (!stack.isEmpty()) paintPages(stack, atlas, *cache.ownersOf(mesh, atlas, owning), {}, pages, painting);
    cache.finish();
    reportProgress(progress, 1);
    return pages;
}

} // namespace

std::vector<Image> composite(const TriangleMesh& mesh, const Atlas& atlas,
                             const std::vector<TextureLayer>& layers, std::array<std::uint8_t, 3> baseColour,
                             CompositionCache& cache, const Progress& progress) {
    return composed<std::uint8_t>(mesh, atlas, layers, baseColour, cache, progress);
}

std::vector<DeepImage> compositeDeep(const TriangleMesh& mesh, const Atlas& atlas,
                                     const std::vector<TextureLayer>& layers,
                                     std::array<std::uint8_t, 3> baseColour, CompositionCache& cache,
                                     const Progress& progress) {
    return composed<std::uint16_t>(mesh, atlas, layers, baseColour, cache, progress);
}

std::vector<Image> composite(const TriangleMesh& mesh, const Atlas& atlas,
                             const std::vector<TextureLayer>& layers, std::array<std::uint8_t, 3> baseColour,
                             const Progress& progress) {
    CompositionCache cache;
    return composite(mesh, atlas, layers, baseColour, cache, progress);
}

/// Triangle by triangle: patches do not overlap, so that no texel's centre lies inside two. A sliver may hold
/// no centre at all, which is why triangles count by what touches them.
LayerCoverage coverage(const TriangleMesh& mesh, const Atlas& atlas, const TextureLayer& layer) {
    checkAtlas(mesh, atlas);
    TextureLayer only = layer;
    only.blending = Blending::Normal; // which decides colours, and not what they cover
    CompositionCache cache;
    const LayerStack stack(mesh, atlas.corners, {only}, {}, cache);
    const PageStrip whole{0, 0, atlas.options.size, {}};
    std::vector<LayerCoverage> covered(mesh.triangles.size());
    tbb::parallel_for(std::size_t{0}, covered.size(), [&](std::size_t i) {
        const auto triangle = static_cast<std::uint32_t>(i);
        const TriangleLayers layers(stack, triangle);
        if (layers.layers().empty()) return;
        PatchScan(atlas.corners[i])
            .forEachTexel(whole, atlas.options.size, touching, [&](const PatchTexel& texel) {
                if (!(layers.layers().front().at(texel).weight >= leastSeenWeight)) return;
                covered[i].triangles = 1;
                covered[i].texels += texel.distance == 0 ? 1 : 0;
            });
    });
    LayerCoverage sum;
    for (const LayerCoverage& one : covered) {
        sum.texels += one.texels;
        sum.triangles += one.triangles;
    }
    return sum;
}

} // namespace esm
