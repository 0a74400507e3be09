#include "core/texture/layers/texel_owners.h"

#include "core/support/parallel_steps.h"
#include "core/texture/layers/patch_scan.h"
#include "core/texture/texture_limits.h"

#include <algorithm>
#include <limits>

namespace esm {

namespace {

static_assert(texture_limits::largestPageSize <= std::numeric_limits<std::uint16_t>::max());

/// Texels of one patch lie side by side in a row, so spans take a small part of the memory that a number for
/// each texel would (9 MiB for 4096 × 4096 texels and 20 000 triangles). By triangles and not by rows, so
/// that what is made for a triangle serves all its texels of the strip.
std::vector<TexelSpan> spansOf(const Atlas& atlas, const PageStrip& strip) {
    const StripOwners owners(atlas, strip, fillReach(atlas.options));
    std::vector<TexelSpan> spans;
    for (int y = strip.firstRow; y < strip.endRow; ++y) {
        for (int x = 0, first = 0; x < atlas.options.size; first = x) {
            const std::uint32_t owner = owners.at(first, y);
            while (x < atlas.options.size && owners.at(x, y) == owner)
                ++x;
            if (owner != StripOwners::nobody)
                spans.push_back({owner, static_cast<std::uint16_t>(y), static_cast<std::uint16_t>(first),
                                 static_cast<std::uint16_t>(x)});
        }
    }
    std::stable_sort(spans.begin(), spans.end(),
                     [](const TexelSpan& a, const TexelSpan& b) { return a.triangle < b.triangle; });
    spans.shrink_to_fit();
    return spans;
}

} // namespace

TexelOwners::TexelOwners(const TriangleMesh& mesh, const Atlas& atlas, const Progress& progress)
    : m_options(atlas.options), m_corners(atlas.corners), m_page(atlas.page),
      m_patches(patchNumbers(mesh, atlas)) {
    ProgressParts parts(progress);
    reportProgress(progress, 0);
    const std::vector<PageStrip> strips = pageStrips(atlas);
    reportProgress(parts.next(0.1), 1);
    m_strips.resize(strips.size());
    forEachInParallel(strips.size(), parts.rest(), [&](std::size_t i) {
        m_strips[i] = {strips[i].page, strips[i].firstRow / rowsPerStrip, spansOf(atlas, strips[i])};
    });
}

bool TexelOwners::areOf(const Atlas& atlas) const {
    return m_options.size == atlas.options.size && m_options.pages == atlas.options.pages &&
           m_options.gap == atlas.options.gap && m_page == atlas.page && m_corners == atlas.corners;
}

} // namespace esm
