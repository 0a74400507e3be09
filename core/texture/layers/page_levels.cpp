#include "core/texture/layers/page_levels.h"

#include "core/support/errors.h"
#include "core/support/parallel_steps.h"
#include "core/texture/layers/patch_scan.h"
#include "core/texture/texture_limits.h"

#include <algorithm>
#include <cmath>

namespace esm {

namespace {

/// Blocks of texels that become one must not reach across the strips in which pages are scanned, of 2⁵ rows.
constexpr int mostLevels = 5;

/// A tile of a page, and in which patches its texels lie, row by row.
struct OwnedTile {
    const TiledImage::Tile& pixels;
    const std::uint32_t* patches;

    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(pageTile.width) +
               static_cast<std::size_t>(x);
    }
};

/// A square of a tile's texels that becomes one.
struct Block {
    int x, y, size;
};

/// The mean of those texels of a block that belong to one patch; of all where none does. The usual mean of
/// all four mixes whatever lies side by side in the page, which is not what lies side by side on the surface:
/// their borders would show from afar [R 4.3.2.4]. The middle decides whose block it is. Each level
/// is made from the page itself and not from the level before, where who owned what is lost.
void takeMean(const OwnedTile& tile, const Block& block, std::uint8_t* texel) {
    const std::uint32_t patch = tile.patches[tile.index(block.x + block.size / 2, block.y + block.size / 2)];
    std::array<std::uint32_t, 4> sum{};
    std::uint32_t count = 0;
    for (int y = block.y; y < block.y + block.size; ++y) {
        for (int x = block.x; x < block.x + block.size; ++x) {
            const std::size_t i = tile.index(x, y);
            if (tile.patches[i] != patch) continue;
            for (std::size_t channel = 0; channel < 4; ++channel)
                sum[channel] += tile.pixels[4 * i + channel];
            ++count;
        }
    }
    for (std::size_t channel = 0; channel < 4; ++channel)
        texel[channel] = static_cast<std::uint8_t>((sum[channel] + count / 2) / count);
}

/// Fills what one tile of the page becomes in a level.
void reduceTile(const OwnedTile& tile, int column, int row, TiledImage& smaller, TileRowPainter& painter) {
    const TileSize part = smaller.tileSize();
    const int size = pageTile.width / part.width;
    const int right = std::min(smaller.width(), (column + 1) * part.width),
              bottom = std::min(smaller.height(), (row + 1) * part.height);
    for (int y = row * part.height; y < bottom; ++y) {
        const int left = column * part.width;
        if (left >= right) break;
        std::uint8_t* texel = painter.run(left, right, y).pixels;
        for (int x = left; x < right; ++x, texel += 4)
            takeMean(tile, {(x - left) * size, (y - row * part.height) * size, size}, texel);
    }
}

/// In which patches the texels of some tiles of a strip lie, one tile behind the other.
class StripTilePatches {
public:
    /// @param columns of the tiles, rising
    /// @param patches of the triangles
    StripTilePatches(const OwnedStrip& strip, const std::vector<std::uint32_t>& patches,
                     const std::vector<int>& columns, int columnsOfPage)
        : m_patches(patches), m_places(static_cast<std::size_t>(columnsOfPage), -1),
          m_texels(columns.size() * tileTexels, nobody) {
        for (std::size_t i = 0; i < columns.size(); ++i)
            m_places[static_cast<std::size_t>(columns[i])] = static_cast<int>(i);
        for (const TexelSpan& span : strip.spans)
            for (int column = span.first / pageTile.width; column * pageTile.width < span.end; ++column)
                if (m_places[static_cast<std::size_t>(column)] >= 0) fill(span, column);
    }

    const std::uint32_t* of(int column) const { return &m_texels[firstOf(column)]; }

private:
    static constexpr std::uint32_t nobody = StripOwners::nobody;
    static constexpr std::size_t tileTexels =
        std::size_t{pageTile.width} * static_cast<std::size_t>(pageTile.height);

    std::size_t firstOf(int column) const {
        return static_cast<std::size_t>(m_places[static_cast<std::size_t>(column)]) * tileTexels;
    }

    void fill(const TexelSpan& span, int column) {
        const int left = column * pageTile.width, first = std::max<int>(span.first, left),
                  end = std::min<int>(span.end, left + pageTile.width);
        const int row = span.row % pageTile.height;
        const auto start = static_cast<std::size_t>(row * pageTile.width + first - left);
        std::fill_n(&m_texels[firstOf(column) + start], end - first, m_patches[span.triangle]);
    }

    const std::vector<std::uint32_t>& m_patches;
    std::vector<int> m_places; ///< of each column among the tiles; −1 of one that is not asked for
    std::vector<std::uint32_t> m_texels;
};

std::vector<int> changedColumns(const TiledImage& page, const TiledImage* before, int row) {
    std::vector<int> columns;
    for (int column = 0; column < page.columns(); ++column)
        if (!before || !page.sharesTile(*before, column, row)) columns.push_back(column);
    return columns;
}

void reduceStrip(const TiledImage& page, const TiledImage* before, const OwnedStrip& strip,
                 const std::vector<std::uint32_t>& patches, std::vector<TiledImage>& smaller) {
    const std::vector<int> columns = changedColumns(page, before, strip.row);
    if (columns.empty()) return;
    const StripTilePatches inPatches(strip, patches, columns, page.columns());
    for (TiledImage& level : smaller) {
        if (strip.row >= level.rows()) continue;
        TileRowPainter painter(level, strip.row);
        for (const int column : columns)
            reduceTile({page.tile(column, strip.row), inPatches.of(column)}, column, strip.row, level,
                       painter);
    }
}

/// A page halved so often, of which nothing is known yet.
TiledImage emptyLevel(int size, int level) {
    return {size >> level, size >> level, {pageTile.width >> level, pageTile.height >> level}, {0, 0, 0, 0}};
}

void check(const Atlas& atlas, const TiledPages& pages) {
    std::vector<std::string> problems = validate(atlas, atlas.corners.size());
    const int size = atlas.options.size;
    const auto isForeign = [&](const TiledImage& page) {
        return page.width() != size || page.height() != size || !(page.tileSize() == pageTile);
    };
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
    if (options.layout == AtlasLayout::Own) return 0;
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

SmallerPages smallerPages(const TriangleMesh& mesh, const Atlas& atlas, const TiledPages& pages,
                          const Progress& progress) {
    check(atlas, pages);
    ProgressParts parts(progress);
    const TexelOwners owners(mesh, atlas, parts.next(0.5));
    return smallerPages(atlas, owners, pages, {}, parts.rest());
}

SmallerPages smallerPages(const Atlas& atlas, const TexelOwners& owners, const TiledPages& pages,
                          const HalvedPages& before, const Progress& progress) {
    check(atlas, pages);
    const int levels = usableLevels(atlas.options);
    SmallerPages smaller = before.smaller;
    smaller.resize(pages.size());
    for (std::vector<TiledImage>& page : smaller)
        for (int level = static_cast<int>(page.size()) + 1; level <= levels; ++level)
            page.push_back(emptyLevel(atlas.options.size, level));
    const std::vector<OwnedStrip>& strips = owners.strips();
    forEachInParallel(levels > 0 ? strips.size() : 0, progress, [&](std::size_t i) {
        const auto page = static_cast<std::size_t>(strips[i].page);
        reduceStrip(pages[page], page < before.pages.size() ? &before.pages[page] : nullptr, strips[i],
                    owners.patches(), smaller[page]);
    });
    reportProgress(progress, 1);
    return smaller;
}

} // namespace esm
