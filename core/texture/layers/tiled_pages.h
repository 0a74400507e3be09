#pragma once

#include "core/texture/layers/patch_scan.h"
#include "core/texture/tiled_image.h"

#include <vector>

namespace esm {

/// A texture's pages in tiles, a row of them for each strip that one thread fills. Patches are small and lie
/// anywhere: narrow tiles leave most of a page as it was when a few of them change.
using TiledPages = std::vector<TiledImage>;
constexpr TileSize pageTile{128, rowsPerStrip};

inline TiledPages tiled(const std::vector<Image>& pages) {
    TiledPages made;
    made.reserve(pages.size());
    for (const Image& page : pages)
        made.emplace_back(page, pageTile);
    return made;
}

} // namespace esm
