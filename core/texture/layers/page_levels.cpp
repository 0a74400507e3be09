#include "core/texture/layers/page_levels.h"

#include "core/support/errors.h"
#include "core/texture/layers/patch_scan.h"
#include "core/texture/parallel_steps.h"
#include "core/texture/texture_limits.h"

#include <algorithm>
#include <cmath>

namespace esm {

namespace {

/// Blocks of texels that become one must not reach across the strips in which pages are scanned, of 2⁵ rows.
constexpr int mostLevels = 5;

/// A square of texels that becomes one.
struct Block {
    int x, y, size;
};

/// The mean of those texels of a block that belong to one patch; of all where none does. The usual mean of
/// all four mixes whatever lies side by side in the page, which is not what lies side by side on the surface:
/// the grid of triangles would show from afar [R 4.3.2.4]. The middle decides whose block it is. Each level
/// is made from the page itself and not from the level before, where who owned what is lost.
void takeMean(const Image& page, const StripOwners& owners, const Block& block, std::uint8_t* texel) {
    const std::uint32_t owner = owners.at(block.x + block.size / 2, block.y + block.size / 2);
    std::array<std::uint32_t, 4> sum{};
    std::uint32_t count = 0;
    for (int y = block.y; y < block.y + block.size; ++y) {
        for (int x = block.x; x < block.x + block.size; ++x) {
            if (owners.at(x, y) != owner) continue;
            const std::uint8_t* pixel = page.at(x, y);
            for (std::size_t channel = 0; channel < 4; ++channel)
                sum[channel] += pixel[channel];
            ++count;
        }
    }
    for (std::size_t channel = 0; channel < 4; ++channel)
        texel[channel] = static_cast<std::uint8_t>((sum[channel] + count / 2) / count);
}

void reduceStrip(const Image& page, const StripOwners& owners, const PageStrip& strip, int level,
                 Image& smaller) {
    const int size = 1 << level;
    for (int y = strip.firstRow / size; y < strip.endRow / size; ++y)
        for (int x = 0; x < smaller.width; ++x)
            takeMean(page, owners, {x * size, y * size, size}, smaller.at(x, y));
}

/// While somebody paints, most strips of a page stay as they are: to compare one costs a walk through it, to
/// halve it several.
bool isSame(const Image& page, const Image& before, const PageStrip& strip) {
    const std::uint8_t* first = page.at(0, strip.firstRow);
    return std::equal(first, first + 4 * std::ptrdiff_t{page.width} * (strip.endRow - strip.firstRow),
                      before.at(0, strip.firstRow));
}

Image emptyPage(int size) {
    Image page;
    page.width = page.height = size;
    page.pixels.resize(4 * static_cast<std::size_t>(size) * static_cast<std::size_t>(size));
    return page;
}

void check(const Atlas& atlas, const std::vector<Image>& pages) {
    std::vector<std::string> problems = validate(atlas, atlas.corners.size());
    const int size = atlas.options.size;
    const auto isForeign = [&](const Image& page) { return page.width != size || page.height != size; };
    if (pages.size() != static_cast<std::size_t>(atlas.options.pages) ||
        std::any_of(pages.begin(), pages.end(), isForeign))
        problems.emplace_back("the texture's pages do not belong to its layout");
    if (!problems.empty()) throw InvalidModel(problems);
}

} // namespace

double filledGap(const AtlasOptions& options) {
    return std::min(static_cast<double>(options.gap), 2 * fillReach(options));
}

/// After one halving more than l, a texel is as wide as 2·2ˡ of the page's. The filter reads that far beyond
/// its place, which must be no more than half of the gap: 4·2ˡ ≤ gap. A gap of 8 allows two halvings.
int usableLevels(const AtlasOptions& options) {
    int levels = 0;
    while (levels < mostLevels && 4 << levels <= filledGap(options) && options.size % (2 << levels) == 0)
        ++levels;
    return levels;
}

/// A texel that the filter reads has its middle up to √2 of its own width from the place. It shows the patch
/// as far as half of the gap outside it, so that the rest has to lie inside.
double levelInset(const AtlasOptions& options, int halvings) {
    const double reach = std::sqrt(2.0) * std::ldexp(1.0, halvings);
    return halvings > 0 ? std::max(0.0, reach - filledGap(options) / 2) : 0;
}

SmallerPages smallerPages(const Atlas& atlas, const std::vector<Image>& pages, const Progress& progress) {
    SmallerPages smaller(pages.size());
    for (std::vector<Image>& page : smaller)
        for (int level = 1; level <= usableLevels(atlas.options); ++level)
            page.push_back(emptyPage(atlas.options.size >> level));
    return smallerPages(atlas, pages, {}, std::move(smaller), progress);
}

SmallerPages smallerPages(const Atlas& atlas, const std::vector<Image>& pages,
                          const std::vector<Image>& before, SmallerPages smallerBefore,
                          const Progress& progress) {
    check(atlas, pages);
    const int levels = usableLevels(atlas.options);
    SmallerPages smaller = std::move(smallerBefore);
    const std::vector<PageStrip> strips = pageStrips(atlas);
    forEachInParallel(levels > 0 ? strips.size() : 0, progress, [&](std::size_t i) {
        const PageStrip& strip = strips[i];
        const auto page = static_cast<std::size_t>(strip.page);
        if (page < before.size() && isSame(pages[page], before[page], strip)) return;
        const StripOwners owners(atlas, strip, fillReach(atlas.options));
        for (int level = 1; level <= levels; ++level)
            reduceStrip(pages[page], owners, strip, level,
                        smaller[page][static_cast<std::size_t>(level - 1)]);
    });
    reportProgress(progress, 1);
    return smaller;
}

} // namespace esm
